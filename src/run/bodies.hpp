#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lattice/lattice.hpp"
#include "mechanics/bond_forces.hpp"
#include "mechanics/spectrum.hpp"
#include "run/second_body.hpp"
#include "scene/scene.hpp"
#include "statics/compliance.hpp"
#include "statics/flexibility.hpp"
#include "statics/folding.hpp"

namespace impact {

/// What is made of lattices for a scene, whatever its material and motion: for many scenes the
/// same, see key_of_bodies().
struct Bodies {
  Lattice disk;  ///< or the stretched rectangle
  std::optional<SecondBody> second;
  Triangles triangles;  ///< of the disk
  std::optional<Triangles> second_triangles;
  BondForces bonds;                  ///< of all bodies, one after another; with any constants
  std::optional<Spectrum> spectrum;  ///< of all bonds, for k_a = 1, m = 1 and η = 1
  Flexibility flexibility{};         ///< of the disk that is thrown
  Flexibility second_flexibility{};
  std::vector<std::string> flags;  ///< Run::flags() that files lead to
  /// Of the disk that is thrown.
  std::shared_ptr<ComplianceOnDemand> compliance = std::make_shared<ComplianceOnDemand>();
};

/// With the spectrum if the scene is one of motion, with its γ if the scene is damped.
/// @throw InputError for a lattice that cannot be used.
std::shared_ptr<const Bodies> make_bodies(const Scene& scene);

/// Equal for scenes of which make_bodies() makes the same, but for the spectrum.
std::string key_of_bodies(const Scene& scene);

/// The bonds of the scene's bodies, those of the second with its own constants where the scene
/// gives them. `point_mass` in M.
BondForces bonds_of(const Scene& scene, const Bodies& bodies, double point_mass);

/// Of the second body, which the scene has, in M.
double second_mass(const Bodies& bodies);

/// Of the two bodies that collide, in M: 1 M against a wall.
double reduced_mass(const Scene& scene, const Bodies& bodies);

/// Their spectrum.
Spectrum spectrum_of(const Scene& scene, const Bodies& bodies, double point_mass);

}  // namespace impact
