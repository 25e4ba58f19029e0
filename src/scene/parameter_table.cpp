#include "scene/parameter_table.hpp"

namespace impact {
namespace {

void flatten_into(const YAML::Node& node, const std::string& path, FlatTree& leaves) {
  if (!node.IsMap()) {
    leaves.emplace(path, node);
    return;
  }
  for (const auto& entry : node) {
    const auto name = scalar<std::string>(entry.first);
    if (!name) throw InputError(fmt::format("{}: a key must be a word", one_line(entry.first)));
    flatten_into(entry.second, path.empty() ? *name : path + "." + *name, leaves);
  }
}

}  // namespace

FlatTree flatten(const YAML::Node& tree) {
  FlatTree leaves;
  if (!tree || tree.IsNull()) return leaves;
  if (!tree.IsMap()) {
    throw InputError(fmt::format("got {}, allowed: a map of keys and values", one_line(tree)));
  }
  flatten_into(tree, "", leaves);
  return leaves;
}

std::string one_line(const YAML::Node& node) {
  if (!node || node.IsNull()) return "nothing";
  YAML::Emitter emitter;
  emitter.SetMapFormat(YAML::Flow);
  emitter.SetSeqFormat(YAML::Flow);
  emitter << node;
  return emitter.c_str();
}

}  // namespace impact
