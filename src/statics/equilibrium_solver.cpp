#include "statics/equilibrium_solver.hpp"

#include <algorithm>
#include <limits>

#include "statics/large_equilibrium_solver.hpp"

namespace impact {
namespace {

template <class Solver>
bool take_to_its_end(EquilibriumSearch& search, const std::function<bool()>& stop) {
  Solver solver;
  while (!search.finished()) {
    if (stop && stop()) return false;
    solver.advance({&search});
  }
  return true;
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
    if (place.search->needs_stiffness() || stiffness_.empty()) set_stiffness(place);
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
  const bool first = stiffness_.empty();
  stiffness_.assemble(place.search->field(), place.search->state().position, place.lane);
  if (!first) return;
  factors_.analyzePattern(stiffness_.upper());
  right_hand_side_ = Vector::Constant(stiffness_.upper().rows(), Scalar(0.0));
}

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::factorise(const std::vector<Place>& going) {
  Scalar shift(0.0);
  for (const auto& [lane, search] : going) {
    in_lane(shift, lane) = search->shift() * stiffness_.largest_diagonal(lane);
  }
  factors_.setShift(shift, Scalar(1.0));
  factors_.factorize(stiffness_.upper());
  bool held = false;
  for (const auto& [lane, search] : going) {
    if (!search->field().hold) continue;
    held = true;
    set_lane(lane, search->field().hold->direction().data());
  }
  if (held) response_ = solution();
}

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::solve(const std::vector<Place>& going) {
  for (const auto& [lane, search] : going) {
    set_lane(lane, search->force().data());
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
    search->take(of_lane(solution_, lane), of_lane(response_, lane),
                 stiffness_.largest_diagonal(lane));
  }
}

template <class Scalar>
Eigen::VectorXd BasicEquilibriumSolver<Scalar>::of_lane(const Vector& numbers, int lane) const {
  Eigen::VectorXd one(numbers.size());
  for (Eigen::Index i = 0; i < one.size(); ++i)
    one[i] = in_lane(numbers[stiffness_.place(i)], lane);
  return one;
}

template <class Scalar>
void BasicEquilibriumSolver<Scalar>::set_lane(int lane, const double* values) {
  for (Eigen::Index i = 0; i < right_hand_side_.size(); ++i) {
    in_lane(right_hand_side_[stiffness_.place(i)], lane) = values[i];
  }
}

bool solve(EquilibriumSearch& search, const std::function<bool()>& stop) {
  return LargeEquilibriumSolver::is_for(search.state().position.rows())
             ? take_to_its_end<LargeEquilibriumSolver>(search, stop)
             : take_to_its_end<EquilibriumSolver>(search, stop);
}

template class BasicEquilibriumSolver<double>;
template class BasicEquilibriumSolver<LaneScalar>;

}  // namespace impact
