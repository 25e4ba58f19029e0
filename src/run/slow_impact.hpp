#pragma once

#include <memory>

#include "reduced/modal_motion.hpp"
#include "reduced/reduced_motion.hpp"
#include "run/compose.hpp"
#include "run/resolution.hpp"
#include "scene/scene.hpp"

namespace impact {

/// The part of numerics.error that a method which moves less than all points may leave out.
constexpr double kMostLeftOut = 0.65;

/// Whether `auto` tries the method `reduced` first: in a scene that can have it (see
/// can_be_reduced()), where no step is given, with so many points, if
///   a v ≤ 2 √(k_a/M), so that the wall stops the disk in more than a period of its slowest
///     vibration,
///   v ≤ 0.006 √(k_a R²/M), so that the displacements are small against the point spacing, and
///   some 100 points at most come into contact, since the work goes with their third power.
/// The run itself says how much it left out, see left_out(); where that is too much, error control
/// goes over to another method.
bool may_be_reduced(const Scene& scene, Eigen::Index points);

/// The last of three runs: a v h = 0.3, or less where numerics.error asks for it, see
/// first_resolution().
Resolution reduced_resolution(const Scene& scene);

/// The motion of a slow impact that starts so. Points come into contact at an energy of
/// numerics.error/10⁴ of that of the impact, which thereby appears: so some twenty of them change e
/// by numerics.error/10³.
std::unique_ptr<ReducedMotion> slow_impact(const Scene& scene, const Composition& composition,
                                           const Resolution& resolution);

/// Whether `auto` may take the method `modal`: in a scene with damping that can have it (see
/// can_be_modal()), begins without forces and gives no step, with so many points, if
///   v ≤ 0.03 √(k_a R²/M), and what it is likely to leave out is at most what it may (a disk from a
///     file is taken for one with a rim and evenly placed points), and
///   it has 100 points at least, and some 100 at most come into contact.
/// Whether it does is a matter of cost. The run itself says how much it left out, see
/// ModalCorrection; where that is too much, error control goes over to another method.
bool may_be_modal(const Scene& scene, Eigen::Index points);

/// The motion of a slow impact in modes that starts so. All runs of a composition share the
/// correction of the one that starts at its height.
std::unique_ptr<ModalMotion> modal_impact(const Scene& scene, const Composition& composition,
                                          const Resolution& resolution);

}  // namespace impact
