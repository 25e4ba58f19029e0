#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/output_lock.hpp"

namespace impact {

/// A folder for the results of one process at a time.
class OutputFolder {
 public:
  /// Creates it where there is none.
  /// @throw InputError as OutputLock, and when it cannot be created.
  explicit OutputFolder(const std::filesystem::path& path);
  /// Removes what it has created, if it is still empty.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool was_there_;
  OutputLock lock_;
};

/// The files of one result, which change together: they are written beside the ones that are there
/// and take their places at the end, so that a folder never holds files of two results.
class ResultFiles {
 public:
  /// `names`: all files that a result may have.
  ResultFiles(std::filesystem::path folder, std::vector<std::string> names);
  /// Removes what has not taken its place.
  ~ResultFiles();
  ResultFiles(const ResultFiles&) = delete;
  ResultFiles& operator=(const ResultFiles&) = delete;

  /// Where to write this one of the files.
  std::filesystem::path beside(const std::string& name) const;

  /// Writes all of this one of the files.
  /// @throw std::runtime_error when that cannot be.
  void write(const std::string& name, const std::string& text) const;

  /// Takes the earlier result out of the folder and puts in the files that have been written.
  /// @throw std::runtime_error when that cannot be; the first file of `names` comes last, so that
  /// a folder that has it has the whole result.
  void take_their_places();

 private:
  std::filesystem::path folder_;
  std::vector<std::string> names_;
};

}  // namespace impact
