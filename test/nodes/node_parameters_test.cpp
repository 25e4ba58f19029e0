#include "nodes/node_parameters.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "document.hpp"

namespace impact {
namespace {

TEST(Documents, HaveTheParametersOfTheNodes) {
  expect_document_has("parameters.md", "simulation node",
                      markdown_table(simulation_node_parameters(), SimulationNodeParameters{}));
  expect_document_has("parameters.md", "analysis node",
                      markdown_table(analysis_node_parameters(), AnalysisNodeParameters{}));
  expect_document_has("parameters.md", "recorder",
                      markdown_table(recorder_node_parameters(), RecorderNodeParameters{}));
  expect_document_has("parameters.md", "replay",
                      markdown_table(replay_node_parameters(), ReplayNodeParameters{}));
}

/// All files of msg/, in alphabetical order.
TEST(Documents, ShowTheMessagesAsTheyAre) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/msg")) {
    files.insert(entry.path());
  }
  std::string messages;
  for (const auto& file : files) {
    if (!messages.empty()) messages += "\n";
    messages +=
        "### " + file.stem().string() + "\n\n```text\n" + content_of(file.string()) + "```\n";
  }
  expect_document_has("topics.md", "messages", messages);
}

}  // namespace
}  // namespace impact
