#include "series/sweep_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cmath>
#include <cstdint>
#include <optional>

#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"

namespace impact {
namespace {

/// Whole numbers beyond this are not all doubles.
constexpr double kLargestExact = 9007199254740992.0;  // 2⁵³

std::vector<std::string> split(const std::string& text, const char* separator) {
  std::vector<std::string> parts;
  boost::algorithm::split(parts, text, boost::algorithm::is_any_of(separator));
  return parts;
}

/// Whether what the key allows begins with this word.
bool allows(const std::string& key, const char* word) {
  const auto& table = scene_parameters();
  return std::any_of(table.begin(), table.end(), [&](const Parameter<Scene>& parameter) {
    return parameter.key == key && parameter.allowed.rfind(word, 0) == 0;
  });
}

struct Range {
  double low;
  double high;
  std::int64_t count;
  bool logarithmic;

  double value(std::int64_t i) const {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    return logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
  }
};

/// Nothing when the parts do not make a range.
std::optional<Range> parse_range(const std::vector<std::string>& parts) {
  if (parts.size() < 3 || parts.size() > 4) return std::nullopt;
  const auto low = real_number(YAML::Node(parts[0]));
  const auto high = real_number(YAML::Node(parts[1]));
  const auto count = whole_number(YAML::Node(parts[2]));
  const bool logarithmic = parts.size() == 4;
  if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high)) return std::nullopt;
  if (!count || *count < 1 || *count > std::int64_t{kMostScenes}) return std::nullopt;
  if (logarithmic && (parts[3] != "log" || *low <= 0.0 || *high <= 0.0)) return std::nullopt;
  if ((*count == 1) != (*low == *high)) return std::nullopt;
  return Range{*low, *high, *count, logarithmic};
}

std::vector<std::string> range_values(const std::string& key, const std::string& text) {
  const std::vector<std::string> parts = split(text, ":");
  const std::optional<Range> range = parse_range(parts);
  if (!range) {
    throw bad_value(key, text, "lo:hi:n or lo:hi:n:log with n values, and above 0 with log");
  }
  const bool whole = allows(key, "whole number");
  if (whole && std::max(std::abs(range->low), std::abs(range->high)) > kLargestExact) {
    throw bad_value(key, text, "a range within ±2^53, or a list of values");
  }
  std::vector<std::string> values{parts[0]};
  for (std::int64_t i = 1; i < range->count - 1; ++i) {
    values.push_back(whole ? fmt::format("{:.0f}", range->value(i))
                           : fmt::format("{:.12g}", range->value(i)));
  }
  if (range->count > 1) values.push_back(parts[1]);
  return values;
}

}  // namespace

std::vector<std::string> sweep_values(const std::string& key, const std::string& text) {
  const bool is_range = text.find(':') != std::string::npos && !allows(key, "text");
  if (!is_range && text.find_first_of("[]{}") != std::string::npos && !allows(key, "text")) {
    throw bad_value(key, text, "v1,v2,… or lo:hi:n or lo:hi:n:log");
  }
  return is_range ? range_values(key, text) : split(text, ",");
}

std::vector<Scene> parse_sweep(const FlatTree& keys, const std::vector<std::string>& assignments) {
  std::vector<Assignment> parsed;
  parsed.reserve(assignments.size());
  for (const std::string& text : assignments) {
    parsed.push_back(parse_assignment(text, "key=values"));
  }
  std::vector<KeyValues> lists;
  for (const auto& [key, text] : with_full_keys(keys, std::move(parsed))) {
    const auto is_key = [&, name = key](const KeyValues& list) { return list.first == name; };
    if (std::any_of(lists.begin(), lists.end(), is_key)) {
      throw InputError(shown(key) + ": given twice");
    }
    YAML::Node values(YAML::NodeType::Sequence);
    for (const std::string& value : sweep_values(key, text)) {
      values.push_back(parse_value(key, value));
    }
    lists.emplace_back(key, values);
  }
  for (const KeyValues& list : lists_of(keys)) {
    const auto is_key = [&](const KeyValues& other) { return other.first == list.first; };
    if (std::none_of(lists.begin(), lists.end(), is_key)) lists.push_back(list);
  }
  return parse_combinations(keys, lists);
}

}  // namespace impact
