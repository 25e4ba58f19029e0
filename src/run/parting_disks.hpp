#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "mechanics/system.hpp"
#include "run/bodies.hpp"
#include "run/free_body.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Whether disks that have met can meet again.
///
/// Two of them fly apart for good where they move apart and the distance of their centres exceeds
/// what both reach, and the gap at which all points together would hold the limit. The first and
/// the last disk have to.
///
/// Of the others of a row two may also stand still against each other: where the energy of their
/// relative motion is below 10⁻³, and that of their contact below remaining_fraction(), of the
/// impact's. Equal disks stop each other almost, and then drift together or apart for a time that
/// is no part of the impact. What they may do to each other later is another one.
class PartingDisks {
 public:
  /// `bodies` must live as long.
  PartingDisks(const Scene& scene, const Bodies& bodies);

  /// As FreeFlight::energy_bound(): of the contacts of all pairs that fly apart.
  double energy_bound(const System& system, double most);

 private:
  struct Flyer {
    PointArray position;
    BodyMotion motion;
  };
  using Pair = std::pair<std::size_t, std::size_t>;

  bool stand_still(const System& system, const std::vector<Flyer>& flyers, Pair pair) const;
  std::vector<double> reaches(const System& system, const std::vector<Flyer>& flyers);

  double remaining_;
  double impact_energy_;
  std::vector<FreeBody> disks_;
};

}  // namespace impact
