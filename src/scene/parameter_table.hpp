#pragma once

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lattice/input_error.hpp"
#include "scene/suggestion.hpp"

namespace impact {

/// The leaves of a YAML tree of maps by their dotted path: {"impact.velocity": 0.01, …}.
using FlatTree = std::map<std::string, YAML::Node>;

/// @throw InputError when the tree is neither a map nor empty, is nested without end, or gives a
/// key twice.
FlatTree flatten(const YAML::Node& tree);

/// An interval of allowed numbers; written `[low, high]`, `(low, high]`, ….
struct Interval {
  double low;
  double high;
  bool low_included = true;

  bool contains(double value) const {
    return (low_included ? value >= low : value > low) && value <= high;
  }
  std::string text() const {
    return fmt::format("{}{:g}, {:g}]", low_included ? '[' : '(', low, high);
  }
};

/// One parameter of the struct `T`: the single place from which its validation, its writing and
/// its line in doc/parameters.md come.
template <class T>
struct Parameter {
  std::string key;      ///< dotted path
  std::string unit;     ///< "-" for none
  std::string allowed;  ///< type and range, as shown in errors and in the page
  std::string meaning;
  /// False when this parameter does not exist for this struct (a load in a collision).
  std::function<bool(const T&)> applies = [](const T&) { return true; };
  /// Sets the value if `node` holds an allowed one; false otherwise.
  std::function<bool(T&, const YAML::Node&)> read{};
  std::function<YAML::Node(const T&)> write{};
};

/// The shortest decimal number that gives the same bits again, in a form that is a number for
/// readers of YAML 1.1 and of YAML 1.2: `1.0e-05`, `.nan`, `-.inf`.
YAML::Node exact(double value);

/// The node as a cell of a table: its text, where exact() has written it a number as in C (`1e-05`,
/// `nan`).
std::string cell_text(const YAML::Node& node);

template <class V>
std::optional<V> scalar(const YAML::Node& node) {
  V value{};
  if (!node.IsScalar() || !YAML::convert<V>::decode(node, value)) return std::nullopt;
  return value;
}

/// True for a text in quotes, which is no number and no truth value.
inline bool is_quoted(const YAML::Node& node) { return node.Tag() == "!"; }

/// A decimal number. One with a leading zero is none: 010 is eight to YAML 1.1, ten to YAML 1.2.
std::optional<double> real_number(const YAML::Node& node);

inline std::optional<double> number_in(const YAML::Node& node, const Interval& interval) {
  const std::optional<double> value = real_number(node);
  return value && std::isfinite(*value) && interval.contains(*value) ? value : std::nullopt;
}

/// A real number. `member` returns a reference to it, given a `T&`.
template <class T, class Member>
Parameter<T> real(std::string key, std::string unit, Interval interval, std::string meaning,
                  Member member) {
  Parameter<T> parameter{std::move(key), std::move(unit), "number in " + interval.text(),
                         std::move(meaning)};
  parameter.read = [interval, member](T& target, const YAML::Node& node) {
    const auto value = number_in(node, interval);
    if (value) member(target) = *value;
    return value.has_value();
  };
  parameter.write = [member](T target) { return exact(member(target)); };
  return parameter;
}

/// A real number or the word `auto`, held as std::optional<double>.
template <class T, class Member>
Parameter<T> real_or_auto(std::string key, std::string unit, Interval interval, std::string meaning,
                          Member member) {
  Parameter<T> parameter{std::move(key), std::move(unit), "auto or number in " + interval.text(),
                         std::move(meaning)};
  parameter.read = [interval, member](T& target, const YAML::Node& node) {
    if (node.IsScalar() && node.Scalar() == "auto") {
      member(target).reset();
      return true;
    }
    member(target) = number_in(node, interval);
    return member(target).has_value();
  };
  parameter.write = [member](T target) {
    return member(target) ? exact(*member(target)) : YAML::Node("auto");
  };
  return parameter;
}

/// A decimal whole number, without a leading zero.
std::optional<std::int64_t> whole_number(const YAML::Node& node);

template <class T, class Member>
Parameter<T> whole(std::string key, std::int64_t low, std::int64_t high, std::string meaning,
                   Member member) {
  Parameter<T> parameter{std::move(key), "-", fmt::format("whole number in [{}, {}]", low, high),
                         std::move(meaning)};
  parameter.read = [low, high, member](T& target, const YAML::Node& node) {
    const auto value = whole_number(node);
    if (!value || *value < low || *value > high) return false;
    member(target) = static_cast<std::decay_t<decltype(member(target))>>(*value);
    return true;
  };
  parameter.write = [member](T target) { return YAML::Node(member(target)); };
  return parameter;
}

template <class T, class Member>
Parameter<T> flag(std::string key, std::string meaning, Member member) {
  Parameter<T> parameter{std::move(key), "-", "true or false", std::move(meaning)};
  parameter.read = [member](T& target, const YAML::Node& node) {
    const auto value = scalar<bool>(node);
    if (!value || is_quoted(node)) return false;
    member(target) = *value;
    return true;
  };
  parameter.write = [member](T target) { return YAML::Node(member(target)); };
  return parameter;
}

/// One of several words, each standing for a value.
template <class T, class V, class Member>
Parameter<T> choice(std::string key, std::vector<std::pair<std::string, V>> words,
                    std::string meaning, Member member) {
  std::string allowed;
  for (const auto& word : words) allowed += (allowed.empty() ? "" : " or ") + word.first;
  Parameter<T> parameter{std::move(key), "-", std::move(allowed), std::move(meaning)};
  parameter.read = [words, member](T& target, const YAML::Node& node) {
    for (const auto& word : words) {
      if (!node.IsScalar() || node.Scalar() != word.first) continue;
      member(target) = word.second;
      return true;
    }
    return false;
  };
  parameter.write = [words, member](T target) {
    for (const auto& word : words) {
      if (member(target) == word.second) return YAML::Node(word.first);
    }
    return YAML::Node();
  };
  return parameter;
}

template <class T, class Member>
Parameter<T> text(std::string key, std::string meaning, Member member) {
  Parameter<T> parameter{std::move(key), "-", "text", std::move(meaning)};
  parameter.read = [member](T& target, const YAML::Node& node) {
    if (!node.IsScalar()) return false;
    member(target) = node.Scalar();
    return true;
  };
  parameter.write = [member](T target) { return YAML::Node(member(target)); };
  return parameter;
}

template <class T, class Member>
Parameter<T> texts(std::string key, std::string meaning, Member member) {
  Parameter<T> parameter{std::move(key), "-", "list of texts", std::move(meaning)};
  parameter.read = [member](T& target, const YAML::Node& node) {
    if (!node.IsSequence()) return false;
    member(target).clear();
    for (const YAML::Node& element : node) {
      if (!element.IsScalar()) return false;
      member(target).push_back(element.Scalar());
    }
    return true;
  };
  parameter.write = [member](T target) {
    YAML::Node list(YAML::NodeType::Sequence);
    for (const std::string& element : member(target)) list.push_back(element);
    return list;
  };
  return parameter;
}

/// The error for a key that cannot take what it was given.
inline InputError bad_value(const std::string& key, const std::string& got,
                            const std::string& allowed) {
  return InputError(fmt::format("{}: got {}, allowed: {}", shown(key), shown(got), allowed));
}

/// The value as one line, for an error or a table; lists and maps within it are not shown.
std::string one_line(const YAML::Node& node);

/// The keys that apply to `target`.
template <class T>
std::vector<std::string> key_names(const std::vector<Parameter<T>>& table, const T& target) {
  std::vector<std::string> names;
  for (const Parameter<T>& parameter : table) {
    if (parameter.applies(target)) names.push_back(parameter.key);
  }
  return names;
}

/// The error for a key that is none of `known`.
inline InputError unknown_key(const std::string& key, const std::vector<std::string>& known) {
  return InputError(fmt::format("{}: unknown key{}, allowed: {}", shown(key),
                                suggestion(key, known), fmt::join(known, ", ")));
}

/// Sets every parameter of `target` that `values` names, in the order of the table.
/// @throw InputError for a name that the table does not have or that does not apply, a wrong type
/// and a value out of range: one line with key, value and what is allowed. `other_names` are
/// allowed too, but were taken elsewhere.
template <class T>
void read_parameters(const std::vector<Parameter<T>>& table, const FlatTree& values, T& target,
                     const std::vector<std::string>& other_names = {}) {
  for (const Parameter<T>& parameter : table) {
    const auto found = values.find(parameter.key);
    if (found == values.end() || !parameter.applies(target)) continue;
    if (!parameter.read(target, found->second)) {
      throw bad_value(parameter.key, one_line(found->second), parameter.allowed);
    }
  }
  std::vector<std::string> known = other_names;
  for (std::string& name : key_names(table, target)) known.push_back(std::move(name));
  for (const auto& value : values) {
    if (std::find(known.begin() + static_cast<std::ptrdiff_t>(other_names.size()), known.end(),
                  value.first) == known.end()) {
      throw unknown_key(value.first, known);
    }
  }
}

/// The parameters that apply to `target`, as a YAML tree that reads back to the same bits.
template <class T>
YAML::Node write_parameters(const std::vector<Parameter<T>>& table, const T& target) {
  YAML::Node root(YAML::NodeType::Map);
  for (const Parameter<T>& parameter : table) {
    if (!parameter.applies(target)) continue;
    const std::size_t dot = parameter.key.find('.');
    if (dot == std::string::npos) {
      root[parameter.key] = parameter.write(target);
    } else {
      root[parameter.key.substr(0, dot)][parameter.key.substr(dot + 1)] = parameter.write(target);
    }
  }
  return root;
}

/// The table as Markdown, with the values of `defaults`, for doc/parameters.md.
template <class T>
std::string markdown_table(const std::vector<Parameter<T>>& table, const T& defaults) {
  std::string rows = "| key | default | allowed | meaning |\n|---|---|---|---|\n";
  for (const Parameter<T>& parameter : table) {
    const std::string unit = parameter.unit == "-" ? "" : " " + parameter.unit;
    rows += fmt::format("| `{}` | `{}` | {}{} | {} |\n", parameter.key,
                        one_line(parameter.write(defaults)), parameter.allowed, unit,
                        parameter.meaning);
  }
  return rows;
}

/// The parameters that apply to `target` with its values (but NaN), as text for a terminal.
template <class T>
std::string parameter_list(const std::vector<Parameter<T>>& table, const T& target) {
  std::string text;
  for (const Parameter<T>& parameter : table) {
    if (!parameter.applies(target)) continue;
    const std::string value = one_line(parameter.write(target));
    const std::string unit = parameter.unit == "-" ? "" : " " + parameter.unit;
    text += fmt::format("  {}{}{}  ({})\n      {}\n", parameter.key,
                        value == ".nan" ? " in" : " = " + value, unit, parameter.allowed,
                        parameter.meaning);
  }
  return text;
}

}  // namespace impact
