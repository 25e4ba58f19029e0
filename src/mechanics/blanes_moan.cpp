#include "mechanics/blanes_moan.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "mechanics/kick.hpp"

namespace impact {
namespace {

constexpr std::size_t kDrifts = 11;

// Sixteen digits of the published coefficients; the middle ones make the sums 1.
constexpr double kA1 = 0.123229775946271;
constexpr double kA2 = 0.290553797799558;
constexpr double kA3 = -0.127049212625417;
constexpr double kA4 = -0.246331761062075;
constexpr double kA5 = 0.357208872795928;
constexpr double kA6 = 1.0 - 2.0 * (kA1 + kA2 + kA3 + kA4 + kA5);
constexpr double kB1 = 0.0414649985182624;
constexpr double kB2 = 0.198128671918067;
constexpr double kB3 = -0.0400061921041533;
constexpr double kB4 = 0.0752539843015807;
constexpr double kB5 = -0.0115113874206879;
constexpr double kB6 = 0.5 - (kB1 + kB2 + kB3 + kB4 + kB5);

constexpr std::array<double, kDrifts> kDrift{kA1, kA2, kA3, kA4, kA5, kA6, kA5, kA4, kA3, kA2, kA1};
constexpr std::array<double, kDrifts + 1> kKick{kB1, kB2, kB3, kB4, kB5, kB6,
                                                kB6, kB5, kB4, kB3, kB2, kB1};

}  // namespace

template <class Field>
void BasicBlanesMoan<Field>::restart(Field& field, const State& state) {
  if (field.damped()) throw std::invalid_argument("BlanesMoan: forces depend on velocities");
  field.resize(force_);
  field.evaluate(state.position, state.velocity, force_);
}

template <class Field>
typename Field::Losses BasicBlanesMoan<Field>::step(Field& field, State& state,
                                                    typename Field::Step h) {
  const typename Field::Number h_by_mass = h / field.point_mass;
  for (std::size_t i = 0; i < kDrifts; ++i) {
    field.evaluate_undamped(
        state.position, force_,
        [&](const PointRows& rows) {
          kick_and_drift(rows, kKick[i] * h_by_mass, force_, kDrift[i] * h, state.velocity,
                         state.position);
        },
        [](const PointRows& /*rows*/) {});
  }
  kick(kKick[kDrifts] * h_by_mass, force_, state.velocity);
  return {};
}

template <class Field>
double BasicBlanesMoan<Field>::step_limit(double omega_squared, double /*gamma*/) const {
  return kLimit / std::sqrt(omega_squared);
}

template class BasicBlanesMoan<ForceField>;
template class BasicBlanesMoan<LaneField>;

}  // namespace impact
