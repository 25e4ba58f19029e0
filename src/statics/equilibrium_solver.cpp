#include "statics/equilibrium_solver.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace impact {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

double in_lane(const double& number, int /*lane*/) { return number; }
double& in_lane(double& number, int /*lane*/) { return number; }
double in_lane(const LaneScalar& number, int lane) { return number[lane]; }
double& in_lane(LaneScalar& number, int lane) { return number[lane]; }

template <class Vector>
Eigen::VectorXd of_lane(const Vector& numbers, int lane) {
  Eigen::VectorXd one(numbers.size());
  for (Eigen::Index i = 0; i < one.size(); ++i) one[i] = in_lane(numbers[i], lane);
  return one;
}

template <class Vector>
void set_lane(Vector& numbers, int lane, const double* values) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) in_lane(numbers[i], lane) = values[i];
}

/// The stiffness of the field, with a tie along each axis that shifts freely.
Entries tied_stiffness(const ForceField& field, const PointArray& position) {
  const auto points = static_cast<std::int32_t>(position.rows());
  Entries entries = field.stiffness(position);
  for (const int axis : {0, 1}) {
    if (field.shifts_freely(axis)) entries.emplace_back(axis * points, axis * points, 1.0);
  }
  return entries;
}

}  // namespace

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::advance(const Searches& searches) {
  std::vector<Place> going;
  for (int lane = 0; lane < kSearches; ++lane) {
    EquilibriumSearch* const search = searches[static_cast<std::size_t>(lane)];
    if (search != nullptr && !search->finished()) going.push_back({lane, search});
  }
  if (going.empty()) return;
  for (const Place& place : going) {
    if (place.search->needs_stiffness() || places_.empty()) set_stiffness(place);
  }
  factorise(going);
  solve(going);
  take(going);

  const auto corrected = std::remove_if(going.begin(), going.end(), [](const Place& place) {
    return !place.search->needs_correction();
  });
  going.erase(corrected, going.end());
  if (going.empty()) return;
  solve(going);
  take(going);
}

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::set_stiffness(const Place& place) {
  const Entries entries = tied_stiffness(place.search->field(), place.search->state().position);
  if (places_.empty()) find_places(entries, 2 * place.search->state().position.rows());
  Scalar* const values = stiffness_.valuePtr();
  for (Eigen::Index k = 0; k < stiffness_.nonZeros(); ++k) in_lane(values[k], place.lane) = 0.0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (places_[k] >= 0) in_lane(values[places_[k]], place.lane) += entries[k].value();
  }
}

/// All lanes get the same values, so that one that stays empty can be factorised.
template <class Scalar>
void BasicEquilibriumSolver<Scalar>::find_places(const Entries& entries, Eigen::Index coordinates) {
  std::vector<Eigen::Triplet<Scalar>> lower;
  for (const auto& entry : entries) {
    if (entry.row() < entry.col()) continue;
    lower.emplace_back(entry.row(), entry.col(), Scalar(entry.value()));
  }
  stiffness_.resize(coordinates, coordinates);
  stiffness_.setFromTriplets(lower.begin(), lower.end());
  for (const auto& entry : entries) {
    const int* const rows = stiffness_.innerIndexPtr();
    const int* const end = rows + stiffness_.outerIndexPtr()[entry.col() + 1];
    const int* const place =
        std::lower_bound(rows + stiffness_.outerIndexPtr()[entry.col()], end, entry.row());
    places_.push_back(entry.row() >= entry.col() ? place - rows : -1);
  }
  factors_.analyzePattern(stiffness_);
  right_hand_side_ = Vector::Constant(coordinates, Scalar(0.0));
}

template <class Scalar>
double BasicEquilibriumSolver<Scalar>::largest_diagonal(int lane) const {
  double largest = 0.0;
  for (Eigen::Index column = 0; column < stiffness_.cols(); ++column) {
    const int first = stiffness_.outerIndexPtr()[column];
    largest = std::max(largest, in_lane(stiffness_.valuePtr()[first], lane));
  }
  return largest;
}

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::factorise(const std::vector<Place>& going) {
  Scalar shift(0.0);
  for (const auto& [lane, search] : going) {
    in_lane(shift, lane) = search->shift() * largest_diagonal(lane);
  }
  factors_.setShift(shift, Scalar(1.0));
  factors_.factorize(stiffness_);
  bool held = false;
  for (const auto& [lane, search] : going) {
    if (!search->field().hold) continue;
    held = true;
    set_lane(right_hand_side_, lane, search->field().hold->direction().data());
  }
  if (held) response_ = solution();
}

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::solve(const std::vector<Place>& going) {
  for (const auto& [lane, search] : going) {
    set_lane(right_hand_side_, lane, search->force().data());
  }
  solution_ = solution();
}

/// A pivot of zero ends the factorisation if it is one in all lanes; in one lane it leaves there no
/// finite solution. In both cases there is none that is a number.
template <class Scalar>
typename BasicEquilibriumSolver<Scalar>::Vector BasicEquilibriumSolver<Scalar>::solution() const {
  if (factors_.info() == Eigen::Success) return factors_.solve(right_hand_side_);
  return Vector::Constant(right_hand_side_.size(),
                          Scalar(std::numeric_limits<double>::quiet_NaN()));
}

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::take(const std::vector<Place>& going) {
  for (const auto& [lane, search] : going) {
    search->take(of_lane(solution_, lane), of_lane(response_, lane), largest_diagonal(lane));
  }
}

bool solve(EquilibriumSearch& search, const std::function<bool()>& stop) {
  EquilibriumSolver solver;
  while (!search.finished()) {
    if (stop && stop()) return false;
    solver.advance({&search});
  }
  return true;
}

template class BasicEquilibriumSolver<double>;
template class BasicEquilibriumSolver<LaneScalar>;

}  // namespace impact
