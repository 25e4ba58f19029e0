#include "nodes/parameter_server.hpp"

#include <ros/param.h>
#include <ros/this_node.h>

#include <regex>
#include <string>

namespace impact {
namespace {

YAML::Node real_node(double value) {
  const std::string text = fmt::format("{}", value);
  const bool looks_whole = text.find_first_not_of("-0123456789") == std::string::npos;
  return YAML::Node(looks_whole ? text + ".0" : text);
}

/// Quoted, so that it cannot pass for a number; but rosparam takes 1e-3, which has no point, for a
/// text.
YAML::Node text_node(const std::string& text) {
  static const std::regex exponential("[-+]?[0-9]+[eE][-+]?[0-9]+");
  YAML::Node node(text);
  if (!std::regex_match(text, exponential)) node.SetTag("!");
  return node;
}

YAML::Node to_yaml(XmlRpc::XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(value));
    case XmlRpc::XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return real_node(static_cast<double>(value));
    case XmlRpc::XmlRpcValue::TypeString:
      return text_node(static_cast<std::string>(value));
    case XmlRpc::XmlRpcValue::TypeArray: {
      YAML::Node list(YAML::NodeType::Sequence);
      for (int i = 0; i < value.size(); ++i) {  // NOLINT(modernize-loop-convert): no begin() here
        list.push_back(to_yaml(value[i]));
      }
      return list;
    }
    case XmlRpc::XmlRpcValue::TypeStruct: {
      YAML::Node map(YAML::NodeType::Map);
      for (auto& entry : value) map[entry.first] = to_yaml(entry.second);
      return map;
    }
    default:
      throw InputError("a parameter is neither a truth value, number, text, list nor map");
  }
}

}  // namespace

FlatTree private_parameters() {
  XmlRpc::XmlRpcValue tree;
  if (!ros::param::get(ros::this_node::getName(), tree)) return {};
  return flatten(to_yaml(tree));
}

}  // namespace impact
