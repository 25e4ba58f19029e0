#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "lattice/placement.hpp"
#include "mechanics/surface_contact.hpp"
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
  kLattice,    ///< an elastic lattice, §5 of the paper
  kDisk        ///< another disk or a row of them, free as the first
};

/// What happens to waves at the left, right and bottom side of an elastic wall.
enum class Boundary {
  kReset,   ///< velocities are set to zero at intervals
  kFixed,   ///< points are clamped
  kViscous  ///< dashpots matched to the lattice
};

/// How a disk is turned before it meets the wall.
enum class Orientation {
  kRandom,   ///< as it was placed, or as its file has it
  kBalanced  ///< with its centre of mass over the point that touches first
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
    Orientation orientation = Orientation::kRandom;
  } disk;

  struct Material {
    double k_a = 1.0;
    double k_b = 1.0e-3;
    double eta = 0.0;  ///< η*
  } material;

  struct Wall {
    WallKind kind = WallKind::kPotential;
    double a = 300.0;
    std::optional<double> v0;   ///< empty: a R m c², half of it for points, with m = M/N
    std::optional<double> k_a;  ///< of the bonds of what the disk meets; empty: as in the disk
    std::optional<double> k_b;
    std::optional<double> eta;  ///< η*
    int points = 1269;
    std::optional<double> width;   ///< empty: by the disk's number density
    std::optional<double> height;  ///< empty: by the disk's number density
    double threshold = 0.2;
    GapMeasure gap = GapMeasure::kNormal;
    Boundary boundary = Boundary::kReset;
    double reset_interval = 4.0e-3;
    double radius = 1.0;    ///< of a disk, R
    bool mirrored = false;  ///< whether each disk is the mirror image of the one above it
    int disks = 1;          ///< in a row, one below another
    /// A LAMMPS data file that replaces points, width and height, or radius; empty: none.
    std::string file;
  } wall;

  struct Load {
    double p = 4.0e-3;
    bool hold_rotation = true;
  } load;

  struct Impact {
    double velocity = 0.01;
    double angle = 0.0;         ///< degrees, of the velocity from the wall's normal, towards +x
    double spin = 0.0;          ///< c/R, counter-clockwise
    std::optional<double> gap;  ///< empty: as near as `error` allows

    double normal_velocity() const { return velocity * std::cos(angle * M_PI / 180.0); }
    double tangential_velocity() const { return velocity * std::sin(angle * M_PI / 180.0); }
    double tangent() const { return std::tan(angle * M_PI / 180.0); }
    /// Whether the surface of the disk moves along the wall.
    bool slides() const { return angle != 0.0 || spin != 0.0; }
    /// Roughly the greatest speed at which a point comes towards the wall where they touch, which
    /// is within 0.2 R of the disk's lowest point.
    double approach_velocity() const { return normal_velocity() + 0.2 * std::abs(spin); }
  } impact;

  double gravity = 0.0;  ///< c²/R, on the disk of a collision, towards the wall

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

  /// At which the wall's force grows while the disk comes to it: a v, c/R.
  double wall_rate() const { return wall.a * impact.approach_velocity(); }

  bool has_elastic_wall() const {
    return kind == SceneKind::kCollision && wall.kind == WallKind::kLattice;
  }
  bool hits_disk() const { return kind == SceneKind::kCollision && wall.kind == WallKind::kDisk; }
  /// The points of each disk of a row below a first one of so many; empty: as its file has them.
  std::optional<int> points_of_row_disk(double first_points) const {
    constexpr int kFewest = 3;
    constexpr double kMost = 1e9;  // more than any program takes
    if (wall.mirrored) return static_cast<int>(first_points);
    if (!wall.file.empty()) return std::nullopt;
    const double points = std::round(first_points * wall.radius * wall.radius);
    return std::max(kFewest, static_cast<int>(std::min(points, kMost)));
  }
  bool is_row() const { return hits_disk() && wall.disks > 1; }
  /// Of those bodies that the disk meets and that are made of points.
  std::size_t other_bodies() const {
    if (hits_disk()) return static_cast<std::size_t>(wall.disks);
    return has_elastic_wall() ? 1 : 0;
  }
  /// Of the other bodies, where it is not that of the disk.
  bool has_own_wall_material() const {
    return other_bodies() > 0 && (wall.k_a || wall.k_b || wall.eta);
  }
  Material wall_material() const {
    return {wall.k_a.value_or(material.k_a), wall.k_b.value_or(material.k_b),
            wall.eta.value_or(material.eta)};
  }

  /// Whether the answer is a static solution, found without motion.
  bool is_static() const {
    return kind == SceneKind::kStretch ||
           traits_of(numerics.integrator).stepping == Stepping::kStatic ||
           (kind == SceneKind::kContact && numerics.integrator == IntegratorKind::kAuto &&
            !numerics.step);
  }
  /// Whether the numbers of points are known without reading a file.
  bool has_recipes_only() const { return disk.file.empty() && wall.file.empty(); }
  /// Whether contacts pass from bond to bond.
  bool has_passing_contacts() const { return other_bodies() > 0; }
  /// Whether the disk flies to the potential wall without gravity, spin and a given gap: then no
  /// force acts on any point at first.
  bool flies_without_forces() const {
    return kind == SceneKind::kCollision && !has_passing_contacts() && !impact.gap &&
           impact.spin == 0.0 && gravity == 0.0;
  }
  Circumstances circumstances() const {
    return {is_damped(), has_passing_contacts(), flies_without_forces()};
  }
  /// Whether forces depend on velocities.
  bool is_damped() const {
    return material.eta != 0.0 || (other_bodies() > 0 && wall_material().eta != 0.0) ||
           (has_elastic_wall() && wall.boundary == Boundary::kViscous);
  }
};

}  // namespace impact
