#pragma once

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/RunStatus.h>

#include <optional>
#include <string>

#include "measure/contact_time.hpp"
#include "mechanics/state.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Holds the messages of one run against each other and against its scene, so that damage does not
/// become a number. Each check returns what is wrong, or nothing.
class RunChecks {
 public:
  /// Arrays of one length, at least three points, finite numbers, bonds of points that are there.
  std::string fault_of(const lattice_impact::Lattice& lattice);

  /// The next state and its forces: arrays as long as the lattice, finite numbers, equal time and
  /// step, samples of every step without a gap, their trapezoid as impulse and, in a collision, the
  /// change of the momentum along y to the accuracy of that, (a v h)² of it. `follows`: no message
  /// is missing before it; else it is looked at by itself.
  std::string fault_of(const lattice_impact::ParticleStates& states,
                       const lattice_impact::ContactForces& forces, const Scene& scene,
                       const lattice_impact::RunStatus& status, bool follows);

  /// The run and its phase are possible.
  static std::string fault_of(const lattice_impact::RunStatus& status);

  /// As many states as announced, and where a collision is finished a disk that has left, and an
  /// answer. `states`: those that came.
  std::string fault_at_end(const lattice_impact::RunStatus& status, const Scene& scene,
                           std::uint32_t states) const;

 private:
  /// Of the samples of a message, from the last one before.
  struct Trapezoid {
    double impulse = 0.0;  ///< M c
    double size = 0.0;     ///< the same with each part by its size
  };
  Trapezoid trapezoid(const lattice_impact::ContactForces& forces) const;
  std::string fault_of_samples(const lattice_impact::ContactForces& forces, const Trapezoid& sum,
                               bool every_step) const;
  static std::string fault_of_sliding(const State& start, const Scene& scene);
  std::string fault_of_momentum(double velocity, double time, const Trapezoid& sum,
                                const Scene& scene, double step_size) const;

  std::size_t points_ = 0;
  std::size_t states_ = 0;
  std::uint64_t last_step_ = 0;
  std::optional<ForceSample> last_sample_;
  double last_velocity_ = 0.0;  ///< c, of the centre of mass along y
  double last_time_ = 0.0;      ///< R/c
};

}  // namespace impact
