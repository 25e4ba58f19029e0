#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nodes/viewer_snapshot.hpp"

namespace impact {

/// R.
Eigen::Vector2d centre_of_mass(const lattice_impact::ParticleStates& states);

/// Turns snapshots into markers for rviz, in the namespaces `points`, `bonds` (coloured by their
/// strain), `wall`, `forces` (arrows that end at their points), `centre of mass`, `trace` (of it),
/// `scale` (of the colours) and `text`. Frame `world`; 1 R is 1 m.
class ViewerMarkers {
 public:
  /// Those of the next snapshot to be drawn. What is scaled by the largest so far (arrows, colours)
  /// starts anew with each run.
  visualization_msgs::MarkerArray draw(const Snapshot& snapshot);

  /// Strain at the ends of the colours: that which 5 % of the disk's bonds exceeded when they were
  /// strained most, rounded up to 1, 2 or 5 times a power of ten.
  double strain_range() const { return strain_range_; }

  /// M c²/R, largest force on a point so far.
  double peak_force() const { return peak_force_; }

 private:
  void begin_if_new(const lattice_impact::ParticleStates& states);
  void take_in(const Snapshot& snapshot, const std::vector<double>& strains);
  void add_others(const std_msgs::Header& header, const std::vector<BodySnapshot>& others,
                  std::vector<visualization_msgs::Marker>& markers);
  visualization_msgs::Marker trace(const std_msgs::Header& header) const;
  visualization_msgs::Marker forces(const std_msgs::Header& header, const Snapshot& snapshot) const;
  void add_scale(const std_msgs::Header& header, bool has_wall_lattice,
                 std::vector<visualization_msgs::Marker>& markers) const;

  std::optional<std::uint32_t> run_;
  double time_ = 0.0;  ///< R/c, of the last state drawn
  double strain_range_ = 0.0;
  double peak_force_ = 0.0;
  int most_of_others_ = 2;              ///< markers in use so far, or of another viewer before
  std::vector<Eigen::Vector2d> trace_;  ///< R
};

}  // namespace impact
