#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <set>
#include <string>

namespace impact {

/// Opens a bag to be read.
/// @throw InputError when it is no bag, was not closed, or was recorded by another version of the
/// package, in which messages have other fields.
void open_to_read(const std::string& file, rosbag::Bag& bag);

/// The namespace of a topic: what stands before its last slash, or "/".
std::string name_space_of(const std::string& topic);

/// The namespaces in which a simulation published.
std::set<std::string> simulations_in(rosbag::View& view);

}  // namespace impact
