#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lattice/lattice.hpp"
#include "mechanics/bond_forces.hpp"
#include "mechanics/spectrum.hpp"
#include "reduced/bulk_modes.hpp"
#include "run/placed_body.hpp"
#include "scene/scene.hpp"
#include "statics/compliance.hpp"
#include "statics/flexibility.hpp"
#include "statics/folding.hpp"

namespace impact {

/// A body of a scene, and what follows from its lattice.
struct BodyOfScene : PlacedBody {
  Triangles triangles;
  Flexibility flexibility{};  ///< of a collision
};

/// What is made of lattices for a scene, whatever its material and motion: for many scenes the
/// same, see key_of_bodies().
struct Bodies {
  /// The disk that is thrown or pressed, or the stretched rectangle, and what it meets.
  std::vector<BodyOfScene> all;
  BondForces bonds;                  ///< of all bodies, one after another; with any constants
  std::optional<Spectrum> spectrum;  ///< of all bonds, for k_a = 1, m = 1 and η = 1
  std::vector<std::string> flags;    ///< Run::flags() that files lead to
  /// Of the disk that is thrown.
  std::shared_ptr<ComplianceOnDemand> compliance = std::make_shared<ComplianceOnDemand>();
  std::shared_ptr<BulkModesOnDemand> modes = std::make_shared<BulkModesOnDemand>();

  const Lattice& disk() const { return all.front().lattice; }
  bool is_alone() const { return all.size() == 1; }
  /// Of all bodies but the first.
  Eigen::Index other_points() const;
  /// Of all bodies, one after another.
  Lattice joined() const;
};

/// With the spectrum if the scene is one of motion, with its γ if the scene is damped.
/// @throw InputError for a lattice that cannot be used.
std::shared_ptr<const Bodies> make_bodies(const Scene& scene);

/// Equal for scenes of which make_bodies() makes the same, but for the spectrum.
std::string key_of_bodies(const Scene& scene);

/// The bonds of the scene's bodies, those of all but the first with constants of their own where
/// the scene gives them. `point_mass` in M.
BondForces bonds_of(const Scene& scene, const Bodies& bodies, double point_mass);

/// Of the disk and all others that it may set in motion, in M: 1 M against a wall.
double reduced_mass(const Scene& scene, const Bodies& bodies);

/// Their spectrum.
Spectrum spectrum_of(const Scene& scene, const Bodies& bodies, double point_mass);

}  // namespace impact
