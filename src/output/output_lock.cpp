#include "output/output_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

InputError cannot_be_written(const std::filesystem::path& path) {
  return InputError(fmt::format("{} cannot be written: {}", path.string(), std::strerror(errno)));
}

/// False where the file that was opened has been removed or replaced meanwhile.
bool is_still_at(const std::filesystem::path& path, int descriptor) {
  struct stat opened {};
  struct stat present {};
  return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &present) == 0 &&
         opened.st_dev == present.st_dev && opened.st_ino == present.st_ino;
}

}  // namespace

OutputLock OutputLock::of_file(const std::filesystem::path& path) {
  return {path, O_RDWR | O_CREAT | O_CLOEXEC};
}

OutputLock OutputLock::of_folder(const std::filesystem::path& path) {
  OutputLock lock(path, O_RDONLY | O_DIRECTORY);
  if (access(path.c_str(), W_OK | X_OK) != 0) throw cannot_be_written(path);
  return lock;
}

OutputLock::OutputLock(std::filesystem::path path, int flags) : path_(std::move(path)) {
  constexpr mode_t kForAll = 0666;  // as far as the umask lets
  do {
    descriptor_ = open(path_.c_str(), flags, kForAll);  // NOLINT(*-vararg): of the system
    if (descriptor_ < 0) throw cannot_be_written(path_);
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) continue;
    const int error = errno;
    close(descriptor_);
    errno = error;
    if (error != EWOULDBLOCK) throw cannot_be_written(path_);
    throw InputError(fmt::format("{}: another process is writing to it", path_.string()));
  } while (!is_still_at(path_, descriptor_) && close(descriptor_) == 0);
}

OutputLock::OutputLock(OutputLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputLock::~OutputLock() {
  if (descriptor_ < 0) return;
  struct stat status {};
  const bool is_empty_file = fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode) &&
                             status.st_size == 0 && is_still_at(path_, descriptor_);
  if (is_empty_file) unlink(path_.c_str());
  close(descriptor_);
}

}  // namespace impact
