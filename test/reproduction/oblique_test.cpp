#include "reproduction/oblique.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace impact {
namespace {

using Line = std::map<std::string, double>;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<Line> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text;
  std::getline(file, text);
  const std::vector<std::string> names = cells_of(text);
  std::vector<Line> lines;
  while (std::getline(file, text)) {
    const std::vector<std::string> cells = cells_of(text);
    Line& line = lines.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      line[names[i]] = std::strtod(cells[i].c_str(), nullptr);  // 0 of a text
    }
  }
  return lines;
}

/// A folder that is gone with the object.
class Folder {
 public:
  Folder() { std::filesystem::create_directories(path_); }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("lattice_impact_" + std::to_string(getpid()));
};

/// On a wall as stiff as the disk, at γ = 0 and at 0.995 of the velocity along the wall.
TEST(ReproduceOblique, ComparesEWithTheSlopeOfTheSurface) {
  const Folder folder;
  Reproduction reproduction;
  reproduction.folder = folder.path();
  reproduction.lattices = 2;
  reproduce_oblique(reproduction, {{{1.0, 0.1}}, {0.0, 10.0}});
  const std::vector<Line> means = lines_of(folder.path() / "oblique.csv");
  ASSERT_EQ(means.size(), 2U);
  const auto& straight = means[0];
  EXPECT_EQ(straight.at("lattices"), 2.0);
  EXPECT_EQ(straight.at("refused"), 0.0);
  EXPECT_EQ(straight.at("gain"), 0.0);
  EXPECT_DOUBLE_EQ(straight.at("on_slope"), straight.at("restitution"));

  const std::vector<Line> impacts = lines_of(folder.path() / "oblique_impacts.csv");
  ASSERT_EQ(impacts.size(), 4U);
  const double mean = 0.5 * (impacts[2].at("restitution") + impacts[3].at("restitution"));
  EXPECT_DOUBLE_EQ(means[1].at("restitution"), mean);
  const std::vector<Line> runs = lines_of(folder.path() / "oblique_runs.csv");
  for (const std::size_t i : {2U, 3U}) {
    const Line& impact = impacts[i];
    EXPECT_EQ(impact.at("seed"), static_cast<double>(i - 1));
    // A straight impact at a tenth of the velocity hardly loses energy, one at all of it does.
    EXPECT_GT(impact.at("straight"), 0.99);
    const double slope = impact.at("slope");
    EXPECT_NEAR(impact.at("on_slope"),
                (1.0 + impact.at("straight")) * (1.0 + 10.0 * slope) / (1.0 + slope * slope) - 1.0,
                1e-14);
    EXPECT_EQ(impact.at("gain"), impact.at("restitution") - impact.at("straight"));
    EXPECT_NE(impact.at("gain"), 0.0);
    EXPECT_NE(impact.at("on_chord"), impact.at("on_slope"));
    // Of three scenes for each seed the one at an angle. The energies are extrapolated to zero step
    // each by itself, to within 1 %.
    const double tangential = runs[3 * (i - 2) + 1].at("tangential_energy");
    EXPECT_NEAR(impact.at("tangential_loss"), 1.0 / (1.0 + 0.01) - tangential, 1e-5);
  }
}

}  // namespace
}  // namespace impact
