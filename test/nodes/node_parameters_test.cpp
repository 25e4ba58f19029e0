#include "nodes/node_parameters.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace impact {
namespace {

std::string readme() {
  std::ifstream file(SOURCE_DIR "/README.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Readme, HasTheTablesOfNodeParameters) {
  for (const std::string& table :
       {markdown_table(simulation_node_parameters(), SimulationNodeParameters{}),
        markdown_table(analysis_node_parameters(), AnalysisNodeParameters{})}) {
    EXPECT_NE(readme().find(table), std::string::npos) << "README.md should hold\n" << table;
  }
}

}  // namespace
}  // namespace impact
