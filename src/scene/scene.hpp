#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lattice/placement.hpp"

namespace impact {

/// What is simulated.
enum class SceneKind {
  kContact,   ///< the disk is pressed on the wall and comes to rest
  kCollision  ///< the disk is thrown at the wall
};

enum class WallKind { kPotential };

enum class IntegratorKind {
  kAuto,
  kVerlet,
  kNewton  ///< no motion: a static solution, in a contact scene
};

/// The numbers of a whole simulation. Units: lengths in the disk's radius R, speeds in c, masses
/// in the disk's mass M. parameters() has the meaning, unit and range of each member.
struct Scene {
  SceneKind kind = SceneKind::kCollision;
  std::uint64_t seed = 1;

  struct Disk {
    PlacementRecipe recipe;
    std::string file;  ///< a LAMMPS data file that replaces the recipe; empty: none
  } disk;

  struct Material {
    double k_a = 1.0;
    double k_b = 1.0e-3;
    double eta = 0.0;  ///< η*
  } material;

  struct Wall {
    WallKind kind = WallKind::kPotential;
    double a = 300.0;
    std::optional<double> v0;  ///< empty: a R m c², with m = M/N
  } wall;

  struct Load {
    double p = 4.0e-3;
    bool hold_rotation = true;
  } load;

  struct Impact {
    double velocity = 0.01;
    std::optional<double> gap;  ///< empty: as near as `error` allows
  } impact;

  struct Numerics {
    IntegratorKind integrator = IntegratorKind::kAuto;
    std::optional<double> step;  ///< empty: from the stability bound
    double error = 1.0e-4;
  } numerics;

  struct Output {
    double period = 0.02;
  } output;
};

}  // namespace impact
