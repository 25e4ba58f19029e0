#include "nodes/bag_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <ros/console.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "lattice/input_error.hpp"
#include "scene/parameter_table.hpp"

namespace impact {
namespace {

/// NAME, with .bag left away.
std::string stem_of(const std::string& name) {
  const std::filesystem::path path(name);
  return path.extension() == ".bag" ? (path.parent_path() / path.stem()).string() : name;
}

/// Makes a new, empty file under the first of the names that is not taken; follows no link.
template <class NameOf>
std::string make_new_file(const NameOf& name_of) {
  for (int number = 1;; ++number) {
    std::string name = name_of(number);
    const int file = open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      return name;
    }
    if (errno != EEXIST) throw std::runtime_error(std::strerror(errno));
  }
}

std::string numbered(const std::string& first, const std::string& end, int number) {
  return first + (number > 1 ? fmt::format(".{}", number) : "") + end;
}

void warn_of_another(const std::string& first, const std::string& taken) {
  if (first == taken) return;
  ROS_WARN(
      "%s is there, of a recording that still runs or was cut off; `rosbag reindex %s` mends the "
      "latter",
      first.c_str(), first.c_str());
}

}  // namespace

BagFile::BagFile(std::string name) : name_(std::move(name)) {
  if (name_.empty()) throw bad_value("bag", "\"\"", "name of a file");
  try {
    if (std::filesystem::is_directory(name_)) throw std::runtime_error("it is a folder");
    active_ = make_new_file([&](int number) { return numbered(name_, ".active", number); });
    warn_of_another(numbered(name_, ".active", 1), active_);
    bag_ = std::make_unique<rosbag::Bag>(active_, rosbag::bagmode::Write);
  } catch (const std::exception& error) {
    throw InputError(fmt::format("bag: {} cannot be written: {}", name_, error.what()));
  }
}

BagFile::~BagFile() {
  if (!bag_) return;
  try {
    bag_->close();
  } catch (const std::exception&) {
    static_cast<void>(bag_.release());  // its destructor would write again, and end the program
  }
}

void BagFile::fail(const std::string& cause) {
  const std::string reason = errno != 0 ? fmt::format(" ({})", std::strerror(errno)) : "";
  static_cast<void>(bag_.release());  // as above
  throw std::runtime_error(fmt::format(
      "{0} cannot be written: {1}{2}; `rosbag reindex {0}` makes what it holds readable", active_,
      cause, reason));
}

void BagFile::discard() {
  attempt([&] { bag_->close(); });
  bag_.reset();
  std::filesystem::remove(active_);
}

std::string BagFile::finish(bool complete) {
  attempt([&] { bag_->close(); });
  bag_.reset();
  std::string name = complete ? name_ : make_new_file([&](int number) {
    return numbered(stem_of(name_) + ".incomplete", ".bag", number);
  });
  std::error_code error;
  std::filesystem::rename(active_, name, error);
  if (error) throw std::runtime_error(fmt::format("{}: {}", name, error.message()));
  return name;
}

}  // namespace impact
