#include "nodes/parameter_server.hpp"

#include <ros/param.h>
#include <ros/this_node.h>

namespace impact {
namespace {

YAML::Node to_yaml(XmlRpc::XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(value));
    case XmlRpc::XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return exact(static_cast<double>(value));
    case XmlRpc::XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string>(value));
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
