#pragma once

#include <limits>
#include <string>
#include <vector>

#include "run/run.hpp"

namespace impact {

/// What came out of a scene and what it took.
struct Outcome {
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  double answer = kNaN;                               ///< e, or ξ in R; NaN when there is none
  PointArray position;                                ///< of the disk at the end
  double energy_error = kNaN;                         ///< Run::energy_error()
  double evaluations = kNaN;                          ///< of the forces, in the last run
  double step = kNaN;                                 ///< R/c, at the end of the last run
  double estimated_error = kNaN;                      ///< ErrorControl::estimated_error()
  IntegratorKind integrator = IntegratorKind::kAuto;  ///< used last
  std::string flags;  ///< separated by ';'; where there is no answer, the cause
};

/// Up to where a scene is run.
enum class Until {
  kTime,   ///< one run up to time output.period; no answer where the step had to be halved
  kAnswer  ///< as many runs as its error control asks for
};

/// A scene that is timed, from its description to its answer: composing it, all its runs, and
/// nothing else. Times are processor times, which others on the machine disturb least; they are
/// the wall times of an idle machine, since all happens in one thread.
class TimedScene {
 public:
  TimedScene(Scene scene, Until until) : scene_(std::move(scene)), until_(until) {}

  /// Runs the scene once more. It is given up, without an answer, after `longest` seconds.
  void run(double longest);

  const Scene& scene() const { return scene_; }
  Until until() const { return until_; }
  const Outcome& outcome() const { return outcome_; }
  /// Whether its error control sees to the answer: no step or tolerance is given.
  bool is_verified() const;
  bool has_answer() const { return outcome_.answer == outcome_.answer; }
  double spent() const;             ///< s, in all runs together
  double median_time() const;       ///< s
  double median_wall_time() const;  ///< s
  std::size_t runs() const { return times_.size(); }

 private:
  Scene scene_;
  Until until_;
  Outcome outcome_;
  std::vector<double> times_;
  std::vector<double> wall_times_;
};

/// How much is measured.
struct Effort {
  int rounds = 5;         ///< of interleaved repeats
  double longest = 5.0;   ///< s, of one answer
  double most = 2.0;      ///< s: what has taken as long, repeats included, is not repeated again
  int first_power = 2;    ///< the errors asked for: 10^-first_power …
  int last_power = 10;    ///< … 10^-last_power
  double finer = 1.4143;  ///< quotient of successive steps

  std::vector<double> errors() const;
};

/// @throw std::runtime_error after SIGINT or SIGTERM.
void throw_if_interrupted();

/// Runs all that have an answer again, in turn and in turn backwards, so that a machine
/// that becomes slower for a while does so for all of them. Each has been run once already.
/// @throw std::runtime_error as throw_if_interrupted().
void repeat_in_turn(std::vector<TimedScene>& timed, const Effort& effort);

/// Not timed.
/// @throw RunFailure when it has no answer.
Outcome outcome_of(const Scene& scene, Until until);

/// Whether the scene may have this integrator.
bool can_have(Scene scene, IntegratorKind integrator);

/// Of the methods that `auto` may choose for the scene, the one of highest order.
IntegratorKind most_exact(const Scene& scene);

/// Largest stable step that a run of the scene with this integrator may be given (R/c), the wall at
/// its expected stiffest counted.
double longest_step(Scene scene, IntegratorKind integrator);

}  // namespace impact
