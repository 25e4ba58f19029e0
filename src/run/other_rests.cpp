#include "run/other_rests.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "measure/strain.hpp"
#include "run/end_of_run.hpp"
#include "statics/equilibrium_solver.hpp"
#include "statics/large_equilibrium_solver.hpp"

namespace impact {
namespace {

/// The start of the scene with the disk turned counter-clockwise, its lowest point as high.
State turned(const State& start, double angle) {
  State state = start;
  const Eigen::RowVector2d centre = start.position.colwise().mean();
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  state.position = (start.position.matrix().rowwise() - centre) * turn.transpose();
  state.position.col(1) += start.position.col(1).minCoeff() - state.position.col(1).minCoeff();
  return state;
}

using Searches = std::vector<std::unique_ptr<EquilibriumSearch>>;

/// Takes as many as there are lanes at most to their ends.
void solve_all(const Searches& searches) {
  if (LargeEquilibriumSolver::is_for(searches.front()->state().position.rows())) {
    for (const auto& search : searches) solve(*search);
    return;
  }
  LaneEquilibriumSolver::Searches lanes{};
  std::transform(searches.begin(), searches.end(), lanes.begin(),
                 [](const auto& search) { return search.get(); });
  LaneEquilibriumSolver solver;
  const auto goes_on = [](const auto& search) { return !search->finished(); };
  while (std::any_of(searches.begin(), searches.end(), goes_on)) solver.advance(lanes);
}

/// Rotations (rad) at which the disk rests when it starts from these, at most as many as there are
/// lanes; NaN: it does not come to rest.
std::vector<double> rests_from(const std::vector<double>& angles, const Scene& scene,
                               const Composition& composition) {
  const StrainMeter meter(composition.bodies->disk().points);
  const double tolerance = negligible_static_force(scene, composition.initial.position.rows(),
                                                   composition.resolution.step);
  Searches searches;
  for (const double angle : angles) {
    searches.push_back(std::make_unique<EquilibriumSearch>(
        composition.field, turned(composition.initial, angle), tolerance));
  }
  solve_all(searches);
  std::vector<double> rests;
  rests.reserve(searches.size());
  for (const auto& search : searches) {
    rests.push_back(search->found() ? meter.measure(search->state().position).rotation
                                    : std::numeric_limits<double>::quiet_NaN());
  }
  return rests;
}

bool are_same(double first, double second) {
  constexpr double kSame = 1e-3;  // rad
  return std::abs(std::remainder(first - second, 2.0 * M_PI)) <= kSame;
}

}  // namespace

bool rests_elsewhere(const Scene& scene, const Composition& composition, const PointArray& rest) {
  constexpr std::size_t kStarts = LaneEquilibriumSolver::kSearches;
  constexpr double kNudge = 0.02;  // rad
  const double rotation = StrainMeter(composition.bodies->disk().points).measure(rest).rotation;
  std::vector<double> starts(kStarts, rotation + kNudge);
  for (std::size_t k = 0; k < kStarts; ++k) {
    starts[k] += 2.0 * M_PI * static_cast<double>(k) / kStarts;
  }
  std::vector<double> others;
  for (const double other : rests_from(starts, scene, composition)) {
    if (!std::isnan(other) && !are_same(other, rotation)) others.push_back(other);
  }
  if (others.empty()) return false;
  std::vector<double> nudged = others;
  for (double& other : nudged) other += kNudge;
  const std::vector<double> again = rests_from(nudged, scene, composition);
  return std::inner_product(others.begin(), others.end(), again.begin(), false, std::logical_or<>(),
                            are_same);
}

}  // namespace impact
