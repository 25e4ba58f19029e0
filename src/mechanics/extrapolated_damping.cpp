#include "mechanics/extrapolated_damping.hpp"

#include <cmath>

namespace impact {

template <class Field>
void BasicExtrapolatedDamping<Field>::restart(Field& field, const State& state) {
  field.resize(force_);
  field.evaluate_undamped(state.position, force_);
}

template <class Field>
typename Field::Losses BasicExtrapolatedDamping<Field>::step(Field& field, State& state,
                                                             typename Field::Step h) {
  for (Column& column : columns_) {
    column.integrator.start_with(force_);
    column.state.position = state.position;
    column.state.velocity = state.velocity;
    column.losses = {};
    for (int part = 0; part < column.parts; ++part) {
      const typename Field::Losses lost =
          column.integrator.step(field, column.state, h / column.parts);
      column.losses.dissipated += lost.dissipated;
      column.losses.absorbed += lost.absorbed;
    }
  }
  for (std::size_t level = 1; level < columns_.size(); ++level) {
    for (std::size_t k = columns_.size() - 1; k >= level; --k) {
      const double ratio = static_cast<double>(columns_[k].parts) / columns_[k - level].parts;
      extrapolate(columns_[k - 1], 1.0 / (ratio * ratio - 1.0), columns_[k]);
    }
  }
  const Column& best = columns_.back();
  state.position = best.state.position;
  state.velocity = best.state.velocity;
  field.evaluate_undamped(state.position, force_);
  return best.losses;
}

template <class Field>
void BasicExtrapolatedDamping<Field>::extrapolate(const Column& coarse, double weight,
                                                  Column& fine) {
  const auto improve = [weight](const auto& of_coarse, auto&& of_fine) {
    of_fine += weight * (of_fine - of_coarse);
  };
  improve(coarse.state.position.array(), fine.state.position.array());
  improve(coarse.state.velocity.array(), fine.state.velocity.array());
  improve(coarse.losses.dissipated, fine.losses.dissipated);
  improve(coarse.losses.absorbed, fine.losses.absorbed);
}

template <class Field>
double BasicExtrapolatedDamping<Field>::step_limit(double omega_squared, double gamma) const {
  const double omega = std::sqrt(omega_squared);
  return gamma >= kEnoughDamping * kDampedLimit * omega ? kDampedLimit / omega
                                                        : kUndampedLimit / omega;
}

template class BasicExtrapolatedDamping<ForceField>;
template class BasicExtrapolatedDamping<LaneField>;

}  // namespace impact
