#include "nodes/bag_file.hpp"

#include <gtest/gtest.h>
#include <lattice_impact/Acknowledged.h>
#include <rosbag/view.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "expect_input_error.hpp"

namespace impact {
namespace {

namespace fs = std::filesystem;

class BagFileTest : public testing::Test {
 protected:
  BagFileTest() : folder_(testing::TempDir() + "bag_file_test/") {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~BagFileTest() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return folder_ + name; }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  /// Records one message; returns the name.
  std::string record(const std::string& reader, bool complete) const {
    BagFile bag(file("x.bag"));
    bag.write("/topic", ros::Time(1.0), message(reader));
    return bag.finish(complete);
  }

  static lattice_impact::Acknowledged message(const std::string& reader) {
    lattice_impact::Acknowledged message;
    message.reader = reader;
    return message;
  }

  static std::string reader_in(const std::string& name) {
    rosbag::Bag bag(name, rosbag::bagmode::Read);
    rosbag::View view(bag);
    return view.begin()->instantiate<lattice_impact::Acknowledged>()->reader;
  }

 private:
  std::string folder_;
};

using Names = std::vector<std::string>;

TEST_F(BagFileTest, CompleteOneTakesThePlaceOfAnEarlierOne) {
  EXPECT_EQ(record("first", true), file("x.bag"));
  EXPECT_EQ(record("second", true), file("x.bag"));
  EXPECT_EQ(reader_in(file("x.bag")), "second");
  EXPECT_EQ(files(), Names{"x.bag"});
}

TEST_F(BagFileTest, IncompleteOneDoesNotTakeThePlaceOfAnother) {
  record("good", true);
  EXPECT_EQ(record("less", false), file("x.incomplete.bag"));
  EXPECT_EQ(record("still less", false), file("x.incomplete.2.bag"));
  EXPECT_EQ(reader_in(file("x.bag")), "good");
  EXPECT_EQ(reader_in(file("x.incomplete.bag")), "less");
  EXPECT_EQ(reader_in(file("x.incomplete.2.bag")), "still less");
}

TEST_F(BagFileTest, LeavesAloneWhatAnotherRecordingHasBegun) {
  const BagFile other(file("x.bag"));
  EXPECT_EQ(files(), Names{"x.bag.active"});
  record("second", true);
  EXPECT_EQ(files(), (Names{"x.bag", "x.bag.active"}));
}

TEST_F(BagFileTest, FollowsNoLink) {
  std::ofstream(file("precious")) << "data";
  fs::create_symlink(file("precious"), file("x.bag.active"));
  fs::create_symlink(file("precious"), file("x.bag"));
  record("first", true);
  std::string content;
  std::ifstream(file("precious")) >> content;
  EXPECT_EQ(content, "data");
  EXPECT_EQ(reader_in(file("x.bag")), "first");
}

TEST_F(BagFileTest, DiscardedOneLeavesNothing) {
  BagFile bag(file("x.bag"));
  bag.discard();
  EXPECT_EQ(files(), Names{});
}

TEST_F(BagFileTest, RefusesANameThatCannotBeWritten) {
  EXPECT_INPUT_ERROR(BagFile(""), "bag: got \"\", allowed: name of a file");
  EXPECT_INPUT_ERROR(BagFile(file("")), "cannot be written: it is a folder");
  EXPECT_INPUT_ERROR(BagFile(file("no/x.bag")), "no/x.bag cannot be written: No such file");
}

/// A limit on the size of files stands for a full disk.
TEST_F(BagFileTest, TellsThatTheDiskIsFull) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  std::string said;
  try {
    BagFile bag(file("x.bag"));
    const auto large = message(std::string(10000, 'x'));
    for (int k = 0; k < 1000; ++k) bag.write("/topic", ros::Time(1.0 + k), large);
    bag.finish(true);
  } catch (const std::runtime_error& error) {
    said = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(said.find("x.bag.active cannot be written"), std::string::npos) << said;
  EXPECT_NE(said.find("File too large"), std::string::npos) << said;
  EXPECT_NE(said.find("rosbag reindex"), std::string::npos) << said;
  EXPECT_EQ(files(), Names{"x.bag.active"});
}

}  // namespace
}  // namespace impact
