#include "nodes/node_parameters.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace impact {
namespace {

std::string content(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string readme() { return content(SOURCE_DIR "/README.md"); }

TEST(Readme, HasTheTablesOfNodeParameters) {
  for (const std::string& table :
       {markdown_table(simulation_node_parameters(), SimulationNodeParameters{}),
        markdown_table(analysis_node_parameters(), AnalysisNodeParameters{}),
        markdown_table(recorder_node_parameters(), RecorderNodeParameters{})}) {
    EXPECT_NE(readme().find(table), std::string::npos) << "README.md should hold\n" << table;
  }
}

TEST(Readme, ShowsTheMessagesAsTheyAre) {
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/msg")) {
    EXPECT_NE(readme().find(content(entry.path().string())), std::string::npos)
        << "README.md should hold " << entry.path().filename();
  }
}

}  // namespace
}  // namespace impact
