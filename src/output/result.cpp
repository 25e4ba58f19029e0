#include "output/result.hpp"

#include <algorithm>
#include <cmath>

namespace impact {
namespace {

struct ToYaml {
  YAML::Node operator()(double number) const { return exact(number); }
  YAML::Node operator()(bool truth) const { return YAML::Node(truth); }
  YAML::Node operator()(const std::string& word) const { return YAML::Node(word); }
  YAML::Node operator()(const std::vector<std::string>& words) const {
    YAML::Node list(YAML::NodeType::Sequence);
    list.SetStyle(YAML::EmitterStyle::Flow);
    for (const std::string& word : words) list.push_back(word);
    return list;
  }
};

}  // namespace

const Result::Value* Result::find(const std::string& key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&key](const auto& entry) { return entry.first == key; });
  return found == entries.end() ? nullptr : &found->second;
}

double Result::number(const std::string& key) const {
  const auto* const value = std::get_if<double>(find(key));
  return value == nullptr ? std::nan("") : *value;
}

std::vector<std::string> Result::flags() const {
  const auto* const list = std::get_if<std::vector<std::string>>(find("flags"));
  return list == nullptr ? std::vector<std::string>{} : *list;
}

YAML::Node to_yaml(const Result& result) {
  YAML::Node map;
  for (const auto& [key, value] : result.entries) map[key] = std::visit(ToYaml{}, value);
  return map;
}

Result read_result(const YAML::Node& map) {
  Result result;
  for (const auto& entry : map) {
    const std::string& key = entry.first.Scalar();
    const YAML::Node& value = entry.second;
    if (const auto number = scalar<double>(value)) {
      result.entries.emplace_back(key, *number);
    } else if (value.IsScalar()) {
      result.entries.emplace_back(key, value.Scalar());
    } else if (value.IsSequence()) {
      std::vector<std::string> words;
      for (const YAML::Node& element : value) words.push_back(element.Scalar());
      result.entries.emplace_back(key, std::move(words));
    }
  }
  return result;
}

}  // namespace impact
