#pragma once

#include <filesystem>

namespace impact {

/// Keeps a file or a folder of results to one process. The lock ends with the process, or with the
/// program that it becomes, however that ends: a lock of a dead process is none.
class OutputLock {
 public:
  /// Creates the file where there is none.
  /// @throw InputError when another process holds it, or it cannot be written.
  static OutputLock of_file(const std::filesystem::path& path);
  /// @throw InputError when another process holds it, or it cannot be written into.
  static OutputLock of_folder(const std::filesystem::path& path);

  OutputLock(OutputLock&& other) noexcept;
  OutputLock& operator=(OutputLock&&) = delete;
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  /// Removes a file that is still empty.
  ~OutputLock();

 private:
  OutputLock(std::filesystem::path path, int flags);

  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace impact
