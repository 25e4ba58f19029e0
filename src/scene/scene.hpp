#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lattice/placement.hpp"
#include "mechanics/elastic_wall.hpp"
#include "scene/integrators.hpp"

namespace impact {

/// What is simulated.
enum class SceneKind {
  kContact,    ///< the disk is pressed on the wall and comes to rest
  kCollision,  ///< the disk is thrown at the wall
  kStretch     ///< a rectangle of the disk's recipe is pulled: elastic constants
};

enum class WallKind {
  kPotential,  ///< V₀ exp(−a y), §3 and §4 of the paper
  kLattice     ///< an elastic lattice, §5 of the paper
};

/// What happens to waves at the left, right and bottom side of an elastic wall.
enum class Boundary {
  kReset,   ///< velocities are set to zero at intervals
  kFixed,   ///< points are clamped
  kViscous  ///< dashpots matched to the lattice
};

/// What the lengths of a disk's file are multiplied by: 1, or what makes its radius 1.
enum class FileScale { kNone, kRadius };

/// The numbers of a whole simulation. Units: lengths in the disk's radius R, speeds in c, masses
/// in the disk's mass M. parameters() has the meaning, unit and range of each member.
struct Scene {
  SceneKind kind = SceneKind::kCollision;
  std::uint64_t seed = 1;

  struct Disk {
    PlacementRecipe recipe;
    std::string file;  ///< a LAMMPS data file that replaces the recipe; empty: none
    FileScale scale = FileScale::kNone;  ///< of the file's lengths
  } disk;

  struct Material {
    double k_a = 1.0;
    double k_b = 1.0e-3;
    double eta = 0.0;  ///< η*
  } material;

  struct Wall {
    WallKind kind = WallKind::kPotential;
    double a = 300.0;
    std::optional<double> v0;  ///< empty: a R m c², half of it for an elastic wall, with m = M/N
    int points = 1269;
    std::optional<double> width;   ///< empty: by the disk's number density
    std::optional<double> height;  ///< empty: by the disk's number density
    double threshold = 0.2;
    GapMeasure gap = GapMeasure::kNormal;
    Boundary boundary = Boundary::kReset;
    double reset_interval = 4.0e-3;
    std::string file;  ///< a LAMMPS data file that replaces points, width and height; empty: none
  } wall;

  struct Load {
    double p = 4.0e-3;
    bool hold_rotation = true;
  } load;

  struct Impact {
    double velocity = 0.01;
    std::optional<double> gap;  ///< empty: as near as `error` allows
  } impact;

  struct Stretch {
    double width = 4.0;
    double height = 2.0;
    double strain = 1.0e-3;
  } stretch;

  struct Numerics {
    IntegratorKind integrator = IntegratorKind::kAuto;
    std::optional<double> step;       ///< empty: by `error`
    std::optional<double> tolerance;  ///< of adaptive integrators; empty: by `error`
    double error = 1.0e-4;
    double longest = 3600.0;

    /// Whether step or tolerance are given: then no error control sees to the answer.
    bool are_given() const { return step || tolerance; }
  } numerics;

  struct Output {
    double period = 0.02;
  } output;

  /// Whether the answer is a static solution, found without motion.
  bool is_static() const {
    return kind == SceneKind::kStretch ||
           traits_of(numerics.integrator).stepping == Stepping::kStatic ||
           (kind == SceneKind::kContact && numerics.integrator == IntegratorKind::kAuto &&
            !numerics.step);
  }
  /// Whether the numbers of points are known without reading a file.
  bool has_recipes_only() const { return disk.file.empty() && wall.file.empty(); }
  /// Whether forces depend on velocities.
  bool is_damped() const {
    return material.eta != 0.0 ||
           (kind == SceneKind::kCollision && wall.kind == WallKind::kLattice &&
            wall.boundary == Boundary::kViscous);
  }
};

}  // namespace impact
