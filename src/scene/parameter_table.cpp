#include "scene/parameter_table.hpp"

#include <charconv>
#include <regex>
#include <system_error>

namespace impact {
namespace {

constexpr int kDeepest = 4;

bool has_leading_zero(const std::string& number) {
  static const std::regex leading_zero("[-+]?0[0-9].*");
  return std::regex_match(number, leading_zero);
}

void flatten_into(const YAML::Node& node, const std::string& path, int depth, FlatTree& leaves) {
  if (!node.IsMap()) {
    if (!leaves.emplace(path, node).second) throw InputError(shown(path) + ": given twice");
    return;
  }
  if (depth > kDeepest) throw InputError(shown(path) + ": nested too deeply");
  for (const auto& entry : node) {
    const auto name = scalar<std::string>(entry.first);
    if (!name || name->find('\n') != std::string::npos) {
      throw InputError(fmt::format("{}: a key must be a word", shown(one_line(entry.first))));
    }
    flatten_into(entry.second, path.empty() ? *name : path + "." + *name, depth + 1, leaves);
  }
}

}  // namespace

FlatTree flatten(const YAML::Node& tree) {
  FlatTree leaves;
  if (!tree || tree.IsNull()) return leaves;
  if (!tree.IsMap()) {
    throw InputError(
        fmt::format("got {}, allowed: a map of keys and values", shown(one_line(tree))));
  }
  flatten_into(tree, "", 0, leaves);
  return leaves;
}

YAML::Node exact(double value) {
  if (std::isnan(value)) return YAML::Node(".nan");
  if (std::isinf(value)) return YAML::Node(value > 0.0 ? ".inf" : "-.inf");
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  const bool has_point = text.find('.') != std::string::npos;
  if (exponent != std::string::npos && !has_point) text.insert(exponent, ".0");
  return YAML::Node(text);
}

std::string cell_text(const YAML::Node& node) {
  static const std::regex of_yaml(R"(-?\d\.0e.*|-?\.inf|\.nan)");
  if (!node.IsScalar()) return one_line(node);
  const std::optional<double> value = scalar<double>(node);
  return value && std::regex_match(node.Scalar(), of_yaml) ? fmt::format("{}", *value)
                                                           : node.Scalar();
}

std::optional<double> real_number(const YAML::Node& node) {
  const std::optional<double> value = scalar<double>(node);
  return is_quoted(node) || has_leading_zero(node.Scalar()) ? std::nullopt : value;
}

std::optional<std::int64_t> whole_number(const YAML::Node& node) {
  if (!node.IsScalar() || is_quoted(node) || has_leading_zero(node.Scalar())) return std::nullopt;
  const std::string& text = node.Scalar();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string one_line(const YAML::Node& node) {
  if (!node || node.IsNull()) return "nothing";
  if (node.IsMap()) return "a map";
  if (node.IsSequence()) {
    std::string elements;
    for (const YAML::Node& element : node) {
      const std::string text = element.IsSequence() ? "a list" : one_line(element);
      elements += (elements.empty() ? "" : ", ") + text;
    }
    return "[" + elements + "]";
  }
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << node.Scalar();
  const bool plain =
      !node.Scalar().empty() && !is_quoted(node) && node.Scalar().find('\n') == std::string::npos;
  return plain ? node.Scalar() : emitter.c_str();
}

}  // namespace impact
