#pragma once

#include <Eigen/Core>
#include <string>

#include "scene/scene.hpp"

namespace impact {

/// What a scene will take until it has its answer, roughly: within a factor of 3 where no error
/// control, fold or blow-up intervenes.
struct Forecast {
  double steps = 0.0;    ///< of all runs; of a static solution, iterations
  double seconds = 0.0;  ///< of one core of a present processor
};

/// By the scene alone, from constants that were measured once: no lattice is made and nothing is
/// timed, so that the same scenes are refused on every machine. A disk.file or wall.file counts as
/// so many points as the scene's recipe has.
Forecast forecast(const Scene& scene);

/// Of lattices with so many points: the disk's, or the rectangle's, and those of all other bodies.
Forecast forecast(const Scene& scene, Eigen::Index points, Eigen::Index other_points);

/// "2.1e+08 steps and 12 min on one processor".
std::string text(const Forecast& forecast);

/// "12 min" for so many seconds.
std::string text_of_time(double seconds);

/// From here on (s) a user is told what a scene will take.
constexpr double kWorthTelling = 60.0;

/// @throw InputError when the scene takes longer than its numerics.longest, naming the keys to
/// which that is due: those whose defaults would at least halve the time.
void refuse_if_too_long(const Scene& scene);
void refuse_if_too_long(const Scene& scene, Eigen::Index points, Eigen::Index other_points);

}  // namespace impact
