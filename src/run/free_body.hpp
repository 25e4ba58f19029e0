#pragma once

#include <limits>
#include <optional>

#include "mechanics/body_motion.hpp"
#include "mechanics/state.hpp"
#include "mechanics/system.hpp"
#include "scene/scene.hpp"
#include "statics/flexibility.hpp"
#include "statics/folding.hpp"
#include "statics/tethers.hpp"

namespace impact {

/// What is left of a disk's motion besides the velocity of its centre of mass.
struct InnerMotion {
  double energy;            ///< kinetic and bond energy in the frame of the centre of mass, M c²
  double angular_momentum;  ///< M c R
};

/// Bounds of the motion of a free disk, for all time.
struct InnerBounds {
  bool hold;                 ///< false: too much energy for the bounds of first order
  double counter_clockwise;  ///< the greatest spin in this direction, at least 0, c/R
  double clockwise;          ///< the same in the other
  double swing;              ///< how far a point may come out of the turned reference lattice, R
};

/// A disk on which no force acts from outside: the energy E in the frame of its centre of mass does
/// not grow. The disk is its reference lattice, turned by the angle θ of the best fit, and
/// displacements u from there.
///   U = E − L²/(2 I), without damping, is what bonds can hold, since the angular momentum L is
///     constant; with damping it is E.
///   u = √(2 U C/k_a) with the largest compliance C of a point.
///   |dθ/dt| ≤ (|L| + U/ω₁)/I without damping, since displacements of frequencies from ω₁ on carry
///     an angular momentum of at most U/ω₁; the sign is that of L where |L| is the greater part.
///     With damping, where L is not constant, it is √(2 E/I) in both directions.
///   √(I/mass) lies within √(2 U)/ω₁ of that of the reference lattice, ω₁ that of a mass of 1 M.
/// The compliance and ω₁ are of first order in the strain (see Flexibility). With the elongation
/// X = √(2 U/k_a) of a bond that holds all of U, and the spacing s = √(π/N) R, u has a margin of
/// X/s of itself for the second order; U has one of 10 % for the energy's oscillation in steps of
/// time. Where X exceeds s/3, or the lattice is folded, only the lengths of bonds bound where
/// points are, however the disk turns: see Tethers.
class FreeBody {
 public:
  /// Of a lattice and its triangles, which must live as long. `spacing` s in R, `mass` in M.
  FreeBody(const Lattice& lattice, const Triangles& triangles, const Flexibility& flexibility,
           const Scene::Material& material, double spacing, double mass);

  InnerBounds bounds(const InnerMotion& motion) const;
  /// Whether a lattice in this position is free of folds, which `bounds` ask for.
  bool is_unfolded(const ConstPoints& position) const;
  /// The greatest distance of a point from the centre of mass, for all time (R).
  double reach(const InnerMotion& motion, const ConstPoints& position);
  /// The same however it may be folded.
  double reach_of_tethers(const InnerMotion& motion);

  /// The lattice about its centre of mass.
  const PointArray& reference() const { return reference_; }

 private:
  const Lattice* lattice_;
  const Triangles* triangles_;
  Flexibility flexibility_;
  Scene::Material material_;
  PointArray reference_;
  double spacing_;
  double mass_;
  double gyration_;  ///< R
  std::optional<Tethers> tethers_;
};

/// Of a body that is free.
InnerMotion inner_motion(const System& system, const Body& body, const BodyMotion& motion);
/// The elongation X (R) of a bond that holds this energy (M c²).
double elongation(double energy, double k_a);
/// How far a point of a lattice may come out of place (R), X being the elongation and s the
/// spacing.
double swing(const Flexibility& lattice, double elongation, double spacing);
/// What an energy that is summed up in steps of time may be at most.
double energy_margin(double energy);

/// The least of `most`, most/2, most/4, … that it is true of; infinity if it is not true of the
/// first.
template <class Holds>
double least_that(const Holds& holds, double most) {
  constexpr int kTries = 16;
  if (!holds(most)) return std::numeric_limits<double>::infinity();
  double least = most;
  for (int k = 0; k < kTries && holds(0.5 * least); ++k) least *= 0.5;
  return least;
}

}  // namespace impact
