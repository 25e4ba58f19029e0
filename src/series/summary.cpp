#include "series/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/accumulators/accumulators.hpp>
#include <boost/accumulators/statistics/count.hpp>
#include <boost/accumulators/statistics/error_of.hpp>
#include <boost/accumulators/statistics/error_of_mean.hpp>
#include <boost/accumulators/statistics/mean.hpp>
#include <boost/accumulators/statistics/stats.hpp>
#include <cmath>
#include <map>
#include <utility>

#include "output/result_text.hpp"
#include "output/text_table.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

namespace acc = boost::accumulators;
using MeanAndError =
    acc::accumulator_set<double, acc::stats<acc::tag::mean, acc::tag::error_of<acc::tag::mean>>>;
using Parameters = std::vector<Parameter<Scene>>;
using Group = std::vector<const Row*>;
using Cells = std::vector<std::string>;

std::vector<std::string> main_results(SceneKind kind) {
  if (kind == SceneKind::kCollision) return {"restitution", "contact_duration"};
  if (kind == SceneKind::kStretch) return {"young_modulus", "poisson_ratio", "sound_speed"};
  return {"strain"};
}

/// Those of all rows, each once.
std::vector<std::string> main_results(const std::vector<Row>& rows) {
  std::vector<std::string> keys;
  for (const Row& row : rows) {
    for (const std::string& key : main_results(row.scene.kind)) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
  }
  return keys;
}

std::string text(const Parameter<Scene>& parameter, const Scene& scene) {
  return parameter.applies(scene) ? cell_text(parameter.write(scene)) : "-";
}

/// Cuts a long decimal fraction to six digits.
std::string short_text(const std::string& text) {
  constexpr std::size_t kLong = 10;
  const auto number = scalar<double>(YAML::Node(text));
  const bool is_long = text.size() > kLong && text.find('.') != std::string::npos;
  return number && is_long ? fmt::format("{:.6g}", *number) : text;
}

/// The parameters in which the scenes differ.
Parameters swept_parameters(const std::vector<Row>& rows) {
  Parameters swept;
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    const std::string first = text(parameter, rows.front().scene);
    const bool differs = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
      return text(parameter, row.scene) != first;
    });
    if (differs) swept.push_back(parameter);
  }
  return swept;
}

Cells texts(const Parameters& parameters, const Scene& scene) {
  Cells line;
  for (const Parameter<Scene>& parameter : parameters) line.push_back(text(parameter, scene));
  return line;
}

Cells short_texts(const Parameters& parameters, const Scene& scene) {
  Cells line = texts(parameters, scene);
  std::transform(line.begin(), line.end(), line.begin(), short_text);
  return line;
}

std::string number(double value, double error) {
  return std::isfinite(value) ? digits(value, error) : "-";
}

double result(const Row& row, const std::string& key) {
  const auto found = row.results.find(key);
  return found == row.results.end() ? std::nan("") : found->second;
}

void add_mean(const Group& group, const std::string& key, Cells& line) {
  MeanAndError sample;
  for (const Row* row : group) {
    if (std::isfinite(result(*row, key))) sample(result(*row, key));
  }
  const std::size_t count = acc::count(sample);
  const double error = count > 1 ? acc::error_of<acc::tag::mean>(sample) : std::nan("");
  line.push_back(count > 0 ? digits(acc::mean(sample), 0.1 * error) : "-");
  line.push_back(count > 1 ? fmt::format("{:.2g}", error) : "-");
}

/// The rows with the same values, in the order of their first ones.
std::vector<Group> groups(const std::vector<Row>& rows, const Parameters& parameters) {
  std::vector<Group> groups;
  std::map<Cells, std::size_t> places;
  for (const Row& row : rows) {
    const auto place = places.try_emplace(texts(parameters, row.scene), groups.size()).first;
    if (place->second == groups.size()) groups.emplace_back();
    groups[place->second].push_back(&row);
  }
  return groups;
}

Cells header(const Parameters& parameters) {
  Cells line;
  for (const Parameter<Scene>& parameter : parameters) line.push_back(parameter.key);
  return line;
}

TextTable table_of_runs(const std::vector<Row>& rows, const Parameters& parameters) {
  TextTable table{header(parameters)};
  const auto results = main_results(rows);
  table[0].insert(table[0].end(), results.begin(), results.end());
  table[0].push_back("flags");
  for (const Row& row : rows) {
    Cells line = short_texts(parameters, row.scene);
    for (const std::string& key : results) {
      line.push_back(number(result(row, key), result(row, key + "_error")));
    }
    line.push_back(row.flags.empty() ? "-" : row.flags);
    table.push_back(std::move(line));
  }
  return table;
}

TextTable table_of_means(const std::vector<Row>& rows, const Parameters& parameters) {
  TextTable table{header(parameters)};
  table[0].push_back("runs");
  for (const std::string& key : main_results(rows)) {
    table[0].push_back(key);
    table[0].push_back("std_error");
  }
  table[0].push_back("flagged");
  for (const Group& group : groups(rows, parameters)) {
    Cells line = short_texts(parameters, group.front()->scene);
    line.push_back(std::to_string(group.size()));
    for (const std::string& key : main_results(rows)) add_mean(group, key, line);
    line.push_back(std::to_string(std::count_if(
        group.begin(), group.end(), [](const Row* row) { return !row->flags.empty(); })));
    table.push_back(std::move(line));
  }
  return table;
}

}  // namespace

std::string summary(const std::vector<Row>& rows) {
  Parameters swept = swept_parameters(rows);
  const auto seed = std::find_if(swept.begin(), swept.end(),
                                 [](const auto& parameter) { return parameter.key == "seed"; });
  if (seed == swept.end()) return aligned(table_of_runs(rows, swept));
  swept.erase(seed);
  return aligned(table_of_means(rows, swept));
}

}  // namespace impact
