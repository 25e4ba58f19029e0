#pragma once

#include <lattice_impact/LawFit.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "nodes/series_analysis.hpp"
#include "scene/disk_elasticity.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Fits the paper's laws to the runs of a series while they end: eq. (2) to contacts, eq. (5) to
/// collisions. Only runs that may be compared are fitted together: a group has the same value of
/// every key of the scene but load.P or impact.velocity, and the seed, over which it averages.
/// Collisions that differ in impact.angle alone, and the seed, are averaged by angle.
class SeriesFits {
 public:
  using Output = std::function<void(const lattice_impact::LawFit&)>;

  /// `output` is given each group that a run has changed.
  SeriesFits(const ElasticParameters& elastic, Output output)
      : elastic_(elastic), output_(std::move(output)) {}

  /// Takes in a run that has ended. Those without a sound answer (is_sound()) are counted, not
  /// fitted.
  void add(const ClosedRun& run);

 private:
  struct Group {
    Scene scene;                                      ///< of one of its runs
    std::string undamped;                             ///< the same group with η* = 0
    std::map<double, std::vector<double>> answers{};  ///< by load.P, velocity along y or angle
    std::uint32_t left_out = 0;
  };
  struct DissipationTime {
    double value;
    std::string origin;
  };

  void add_by_angle(const ClosedRun& run);
  void output(lattice_impact::LawFit message, const ClosedRun& run, const std::string& shared,
              const Group& group) const;
  static Group& group_of(std::map<std::string, Group>& groups, const Scene& scene,
                         const std::string& shared_keys);
  lattice_impact::LawFit fit(const Group& group) const;
  lattice_impact::LawFit fit_collisions(const Group& group, const DiskElasticity& elastic) const;
  DissipationTime measure_dissipation(const Group& group, double young_modulus) const;

  ElasticParameters elastic_;
  Output output_;
  std::map<std::string, Group> groups_;    ///< by the keys that their runs share
  std::map<std::string, Group> by_angle_;  ///< the same
};

/// "Hertz law of 5 points, b = 0.92 +- 0.01", or why there is none.
std::string outcome(const lattice_impact::LawFit& law);

}  // namespace impact
