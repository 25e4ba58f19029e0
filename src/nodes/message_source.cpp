#include "nodes/message_source.hpp"

#include <ros/network.h>
#include <xmlrpcpp/XmlRpc.h>

#include <cstdint>

namespace impact {

void MessageSource::note(const std::string& node) {
  last_message_ = ros::WallTime::now();
  if (node_ != node) node_ = node;
}

bool MessageSource::is_alive() const {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue address;
  request[0] = ros::this_node::getName();
  request[1] = node_;
  if (!ros::master::execute("lookupNode", request, response, address, false)) return false;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(address, host, port)) return false;
  XmlRpc::XmlRpcClient node(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller;
  caller[0] = ros::this_node::getName();
  return node.execute("getPid", caller, response);
}

}  // namespace impact
