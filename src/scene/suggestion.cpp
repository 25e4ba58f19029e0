#include "scene/suggestion.hpp"

#include <algorithm>
#include <limits>

namespace impact {
namespace {

constexpr std::size_t kFar = std::numeric_limits<std::size_t>::max() / 2;
constexpr std::size_t kLongest = 64;

/// kFar where more than a third of the letters differ.
std::size_t near_distance(std::string_view a, std::string_view b) {
  const std::size_t distance = typing_distance(a, b);
  return 3 * distance <= std::max(a.size(), b.size()) ? distance : kFar;
}

std::string_view before_dot(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
}

std::string_view after_dot(std::string_view key) { return key.substr(key.rfind('.') + 1); }

std::size_t key_distance(std::string_view word, std::string_view key) {
  const std::size_t of_name = near_distance(after_dot(word), after_dot(key));
  if (before_dot(word).empty()) return std::min(of_name, near_distance(word, key));
  const std::size_t of_group = typing_distance(before_dot(word), before_dot(key));
  if (of_name == 0) return of_group;
  return of_name + near_distance(before_dot(word), before_dot(key));
}

}  // namespace

std::size_t typing_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      d[i][j] = i + j;
      if (i == 0 || j == 0) continue;
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  if (word.size() > kLongest) return {};
  std::size_t least = kFar;
  std::string meant;
  for (const std::string& key : known) {
    const std::size_t distance = key_distance(word, key);
    if (distance >= least) continue;
    least = distance;
    meant = key;
  }
  return meant.empty() ? meant : " (did you mean " + meant + "?)";
}

}  // namespace impact
