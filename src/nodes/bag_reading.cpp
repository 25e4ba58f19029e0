#include "nodes/bag_reading.hpp"

#include <fmt/format.h>
#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/LawFit.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/Restitution.h>
#include <lattice_impact/RunStatus.h>
#include <lattice_impact/Scalars.h>
#include <lattice_impact/Strain.h>

#include <cerrno>
#include <cstring>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

template <class Message>
bool is_another_version_of(const rosbag::ConnectionInfo& connection) {
  return connection.datatype == ros::message_traits::DataType<Message>::value() &&
         connection.md5sum != ros::message_traits::MD5Sum<Message>::value();
}

template <class... Messages>
void refuse_other_versions(rosbag::Bag& bag, const std::string& file) {
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    if (!(is_another_version_of<Messages>(*connection) || ...)) continue;
    throw InputError(
        fmt::format("{} was recorded by another version of lattice_impact, in which {} is another "
                    "message: analyse it with that version",
                    file, connection->datatype));
  }
}

}  // namespace

void open_to_read(const std::string& file, rosbag::Bag& bag) {
  errno = 0;
  try {
    bag.open(file, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw InputError(fmt::format("{} was not closed: mend it with `rosbag reindex`", file));
  } catch (const rosbag::BagException& error) {
    if (errno != 0) throw InputError(fmt::format("{}: {}", file, std::strerror(errno)));
    throw InputError(fmt::format("{} is no bag, or damaged: {}", file, error.what()));
  }
  refuse_other_versions<lattice_impact::Lattice, lattice_impact::ParticleStates,
                        lattice_impact::ContactForces, lattice_impact::RunStatus,
                        lattice_impact::Scalars, lattice_impact::Strain,
                        lattice_impact::Restitution, lattice_impact::LawFit>(bag, file);
}

std::string name_space_of(const std::string& topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == 0 || slash == std::string::npos ? "/" : topic.substr(0, slash);
}

std::set<std::string> simulations_in(rosbag::View& view) {
  std::set<std::string> name_spaces;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    if (connection->datatype == ros::message_traits::DataType<lattice_impact::RunStatus>::value()) {
      name_spaces.insert(name_space_of(connection->topic));
    }
  }
  return name_spaces;
}

}  // namespace impact
