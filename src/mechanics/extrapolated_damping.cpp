#include "mechanics/extrapolated_damping.hpp"

#include <cmath>

namespace impact {

void ExtrapolatedDamping::restart(ForceField& field, const State& state) {
  columns_[0].integrator.restart(field, state);
}

Losses ExtrapolatedDamping::step(ForceField& field, State& state, double h) {
  columns_[1].integrator.start_like(columns_[0].integrator);
  columns_[2].integrator.start_like(columns_[0].integrator);
  for (Column& column : columns_) {
    column.state.position = state.position;
    column.state.velocity = state.velocity;
    column.losses = {};
    for (int part = 0; part < column.parts; ++part) {
      const Losses lost = column.integrator.step(field, column.state, h / column.parts);
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
  columns_[0].integrator.restart(field, state);
  return best.losses;
}

void ExtrapolatedDamping::extrapolate(const Column& coarse, double weight, Column& fine) {
  fine.state.position += weight * (fine.state.position - coarse.state.position);
  fine.state.velocity += weight * (fine.state.velocity - coarse.state.velocity);
  fine.losses.dissipated += weight * (fine.losses.dissipated - coarse.losses.dissipated);
  fine.losses.absorbed += weight * (fine.losses.absorbed - coarse.losses.absorbed);
}

double ExtrapolatedDamping::step_limit(double omega_squared, double gamma) const {
  const double omega = std::sqrt(omega_squared);
  return gamma >= kEnoughDamping * kDampedLimit * omega ? kDampedLimit / omega
                                                        : kUndampedLimit / omega;
}

}  // namespace impact
