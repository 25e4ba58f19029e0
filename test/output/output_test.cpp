#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <optional>

#include "expect_input_error.hpp"
#include "output/output_folder.hpp"

namespace impact {
namespace {

class Output : public testing::Test {
 protected:
  Output() { std::filesystem::remove_all(folder_); }
  ~Output() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "output";
};

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// True when `body` throws an InputError in another process.
template <class Body>
bool is_refused_elsewhere(const Body& body) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      body();
      _exit(0);
    } catch (const InputError&) {
      _exit(1);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

TEST_F(Output, FolderHasOneWriter) {
  std::optional<OutputFolder> first(folder_);
  EXPECT_INPUT_ERROR(OutputFolder{folder_}, "output: another process is writing to it");
  EXPECT_TRUE(is_refused_elsewhere([&] { OutputFolder second(folder_); }));
  first.reset();
  EXPECT_FALSE(is_refused_elsewhere([&] { OutputFolder second(folder_); }));
}

TEST_F(Output, FolderOfADeadProcessIsFree) {
  const pid_t child = fork();
  if (child == 0) {
    const OutputFolder first(folder_);
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_NO_THROW(OutputFolder{folder_});
}

TEST_F(Output, FolderThatIsMadeAndStaysEmptyGoes) {
  { const OutputFolder folder(folder_); }
  EXPECT_FALSE(std::filesystem::exists(folder_));
  std::filesystem::create_directory(folder_);
  { const OutputFolder folder(folder_); }
  EXPECT_TRUE(std::filesystem::exists(folder_));
}

TEST_F(Output, FolderThatCannotBeIsRefused) {
  write(folder_, "a file");
  EXPECT_INPUT_ERROR(OutputFolder{folder_}, "output cannot be written: Not a directory");
  EXPECT_INPUT_ERROR(OutputFolder{folder_ / "below"}, "Not a directory");
  EXPECT_INPUT_ERROR(OutputFolder{"/proc/none"}, "/proc/none: ");
}

TEST_F(Output, FileHasOneWriter) {
  std::filesystem::create_directory(folder_);
  const std::filesystem::path path = folder_ / "table.csv";
  write(path, "1\n");
  {
    const OutputLock first = OutputLock::of_file(path);
    EXPECT_TRUE(is_refused_elsewhere([&] { OutputLock::of_file(path); }));
  }
  EXPECT_FALSE(is_refused_elsewhere([&] { OutputLock::of_file(path); }));
  EXPECT_EQ(content(path), "1\n");
  EXPECT_INPUT_ERROR(OutputLock::of_file(folder_), "output cannot be written: Is a directory");
}

TEST_F(Output, FileThatStaysEmptyGoes) {
  std::filesystem::create_directory(folder_);
  { const OutputLock lock = OutputLock::of_file(folder_ / "table.csv"); }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Output, FilesOfAResultChangeTogether) {
  std::filesystem::create_directory(folder_);
  for (const char* const name : {"result.yaml", "wall.data", "notes"}) write(folder_ / name, "old");
  {
    const ResultFiles broken_off(folder_, {"result.yaml", "scene.yaml", "wall.data"});
    write(broken_off.beside("scene.yaml"), "new");
  }
  EXPECT_EQ(content(folder_ / "result.yaml"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "scene.yaml"));
  ResultFiles files(folder_, {"result.yaml", "scene.yaml", "wall.data"});
  write(files.beside("scene.yaml"), "new");
  write(files.beside("result.yaml"), "new");
  files.take_their_places();
  EXPECT_EQ(content(folder_ / "result.yaml"), "new");
  EXPECT_EQ(content(folder_ / "scene.yaml"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "wall.data"));  // of the result before
  EXPECT_EQ(content(folder_ / "notes"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
}

}  // namespace
}  // namespace impact
