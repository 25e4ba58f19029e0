#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scene/parameter_table.hpp"
#include "scene/scene.hpp"
#include "scene/short_keys.hpp"

namespace impact {

/// A disk of a real material. NaN: not given.
struct RealDisk {
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  double radius = kNaN;      ///< m
  double density = kNaN;     ///< kg/m³
  double mass = kNaN;        ///< kg
  double young = kNaN;       ///< Young's modulus, Pa
  double wave_speed = kNaN;  ///< √(E/ρ), m/s
  double thickness = kNaN;   ///< m
};

/// The keys of a real disk.
const std::vector<Parameter<RealDisk>>& real_disk_parameters();

/// @throw InputError as read_parameters(); unless radius, one of density and mass, one of young and
/// wave_speed are given; and for a mass without a thickness.
RealDisk parse_real_disk(const FlatTree& keys, const std::vector<std::string>& other_names = {});

/// The disk of a text `radius=0.05,density=1100,…`.
/// @throw InputError as parse_real_disk().
RealDisk parse_real_disk(const std::string& text);

/// A number and its unit.
struct Measure {
  double value;
  std::string unit;
};

/// What R, c and M of a scene are for a real disk. A disk without a thickness is a metre thick, and
/// what grows with the thickness is said for each metre.
///
/// The lattice is a sheet in plane stress: its modulus E* (M c²/R²) is E h, M is ρ π R² h, so
/// c = √(E/ρ) / √(π E*).
class SiUnits {
 public:
  /// @throw InputError where E* of the scene's lattice is not known, as that of a file.
  SiUnits(const RealDisk& disk, const Scene& scene);

  double length() const { return length_; }  ///< R, m
  double speed() const { return speed_; }    ///< c, m/s
  double mass() const { return mass_; }      ///< M, kg, or kg/m

  /// A value in a unit of the simulation (`c`, `R/c`, `M c²/R`, …) in SI; nothing for a number
  /// without one.
  std::optional<Measure> in_si(double value, const std::string& unit) const;

  /// How the material became a lattice, in a sentence.
  const std::string& origin() const { return origin_; }

 private:
  double length_;
  double speed_;
  double mass_;
  bool per_metre_;
  std::string origin_;
};

}  // namespace impact
