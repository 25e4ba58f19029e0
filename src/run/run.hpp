#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/flags.hpp"
#include "measure/impact_analysis.hpp"
#include "measure/surface_slope.hpp"
#include "mechanics/system.hpp"
#include "run/compose.hpp"
#include "run/contact_recorder.hpp"
#include "run/end_of_run.hpp"
#include "run/energy_monitor.hpp"
#include "scene/scene.hpp"
#include "statics/equilibrium_search.hpp"

namespace impact {

class Run;

/// Shows an analysis those bodies of a state that are free.
void show(const ForceField& field, const State& state, ImpactAnalysis& analysis);

/// A system, and what makes it go on under the eyes of a run.
struct DrivenSystem {
  std::unique_ptr<const System> system;
  /// Moves or solves it as Run::advance() says and calls Run::observe_step() or
  /// Run::observe_solution(). Empty: somebody else does, as in lanes.
  std::function<void(Run& run, const std::function<bool()>& stop)> drive{};
};

/// One run of a scene, from output to output until its question is answered (see EndOfRun) or
/// until it is given up. It observes a system, whoever moves it.
class Run {
 public:
  /// A run is given up after this many expected times and EndOfRun::time_under_way().
  static constexpr double kPatience = 20.0;

  /// @throw InputError as compose().
  explicit Run(const Scene& scene) : Run(scene, compose_shared(scene)) {}
  /// At the first resolution of the composition.
  Run(const Scene& scene, const std::shared_ptr<const Composition>& composition)
      : Run(scene, composition, composition->resolution) {}
  Run(const Scene& scene, const std::shared_ptr<const Composition>& composition,
      const Resolution& resolution);
  /// Of a motion with the same resolution or, if the scene is static, of make_search().
  Run(const Scene& scene, std::shared_ptr<const Composition> composition,
      const Resolution& resolution, DrivenSystem driven);

  /// Of a system that has a drive. Goes on to the next output time, see output_interval(), or
  /// to the end if that comes first, or to where `stop`, asked every 64 steps, says true. The
  /// output times do not touch the motion. Where the answer is static there is no motion: the first
  /// call goes to the static solution, which is the end, or to where `stop`, asked at each of its
  /// steps, says true.
  /// @throw RunFailure when the energy balance breaks, and when a stretched rectangle does not come
  /// to rest.
  void advance(const std::function<bool()>& stop = {});

  /// To be called after each step of a motion.
  /// @throw RunFailure as advance().
  void observe_step();

  /// To be called when the search for a static solution has finished.
  /// @throw RunFailure as advance().
  void observe_solution(const EquilibriumSearch& search);

  /// At the end of a contact, see EquilibriumSearch::correction().
  const PointArray& correction() const { return correction_; }

  bool finished() const { return finished_; }
  const Lattice& lattice() const { return composition_->bodies->disk(); }
  /// The disk and what it meets, as far as that is made of points.
  const std::vector<BodyOfScene>& bodies() const { return composition_->bodies->all; }
  const System& system() const { return *system_; }
  /// Of all points: the disk's and, after them, those of the other bodies.
  const State& state() const { return system_->state(); }
  State state_of(const Body& body) const;
  State disk_state() const { return state_of(system_->field().first_body()); }
  /// Of the body of this number; 0: the disk.
  State state_of(std::size_t body) const { return state_of(system_->field().body(body)); }
  /// Shows an analysis what flies.
  void show(ImpactAnalysis& analysis) const { impact::show(system_->field(), state(), analysis); }
  /// The method in use.
  IntegratorKind integrator() const { return integrator_; }
  double expected_time() const { return composition_->expected_time; }

  ContactReports take_contact_reports() { return recorder_.take(*system_); }

  /// See EnergyMonitor; 0 of a static solution. Checked every 64 steps, at the end and, once the
  /// kinetic energy is alarming, every fourth step.
  double energy_error() const { return monitor_.error(); }

  /// What a reader should know of the run (doc/results.md). Checks are made every 64 steps and at
  /// the end. `starts_in_wall` (the wall's energy at the start exceeds what numerics.error allows),
  /// `cut_off` (the wall's energy is not negligible at wall.threshold, where it ends abruptly: see
  /// negligible_wall_energy()), `step_reduced` (the wall grew too stiff for the step, which was
  /// halved), `energy_error` (above numerics.error in a scene that gives step or tolerance and so
  /// has no error control), `folded` (a triangle of a lattice had turned over at a check; of a
  /// method that moves less than all points and does not see a fold: one of the disk had less than
  /// two thirds of its area at a check or where the wall pushed most), `beside_wall` (at a check a
  /// part of the disk lay beside an elastic wall, where a wider one would have held more energy
  /// than numerics.error allows: the wall is too narrow), `hops` (EnergyLedger::hops_size exceeds 1
  /// % of the impact's energy), `charge_ignored` (of a file), `floppy` (a lattice from a file that
  /// can change its shape without a change of a bond), `several_rests` (see rests_elsewhere()),
  /// `not_separated` or `not_at_rest` (given up).
  const std::vector<std::string>& flags() const { return flags_; }
  bool has_flag(Flag flag) const { return impact::has_flag(flags_, flag); }

  /// Largest e that energy allows: √(1 + 2U₀/(M v²)) with the wall's energy U₀ at the start and v
  /// the velocity along y; where the disk also slides or spins, U₀ counts that energy too. Of two
  /// or more disks M is the reduced mass and v the velocity of the first against the others.
  double restitution_bound() const { return restitution_bound_; }

  /// Of the surface of an elastic wall under an oblique impact, from edge to edge of the contact:
  /// the SurfaceSlope of its chord_slope(). NaN of other runs. Forces of less than 1 % of the
  /// largest on a point of the disk do not count; looked at every fourth step.
  double surface_slope() const;

  /// Relative error of e, at the end of a collision, for what the wall's potential holds at the
  /// start, U₀ (unless impact.gap is given), and may hold after the end, at most
  /// remaining_fraction() of M v′²/2 (FreeFlight::energy_bound()): their sum over M v′², v′ the
  /// velocity of the centre of mass along y after the impact.
  double tail_error() const;

 private:
  void give_up();
  void look();
  void note_slope();
  void note_folds();
  bool was_pressed_most();
  void note_other_rests();
  void end_motion();
  void finish();

  Scene scene_;
  std::shared_ptr<const Composition> composition_;
  std::unique_ptr<EndOfRun> end_;
  std::unique_ptr<const System> system_;
  std::function<void(Run&, const std::function<bool()>&)> drive_;
  EnergyMonitor monitor_;
  ContactRecorder recorder_;
  std::optional<SurfaceSlope> slope_;  ///< of an oblique impact on an elastic wall
  double contact_energy_before_ = 0.0;
  double restitution_bound_ = 0.0;
  PointArray correction_;  ///< of a contact, at the end
  std::vector<std::string> flags_;
  IntegratorKind integrator_;
  bool finished_ = false;
  double force_ = 0.0;          ///< of the wall at the latest step, M c²/R
  double largest_force_ = 0.0;  ///< at those before
  bool folded_ = false;
  bool beside_wall_ = false;
};

/// The search for the static solution of a scene that is solved without motion.
std::unique_ptr<EquilibriumSearch> make_search(const Scene& scene, const Composition& composition);

}  // namespace impact
