#include "output/si_units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <sstream>

#include "scene/disk_elasticity.hpp"
#include "scene/keys.hpp"

namespace impact {
namespace {

bool is_given(double value) { return !std::isnan(value); }

/// Exponents of R, c and M, and the names in SI of the unit and, where it grows with the thickness,
/// of the unit for each metre.
struct Unit {
  const char* name;
  int length;
  int speed;
  int mass;
  const char* si;
  const char* si_per_metre;
};

constexpr std::array<Unit, 10> kUnits{{{"R", 1, 0, 0, "m", "m"},
                                       {"c", 0, 1, 0, "m/s", "m/s"},
                                       {"R/c", 1, -1, 0, "s", "s"},
                                       {"c/R", -1, 1, 0, "1/s", "1/s"},
                                       {"M", 0, 0, 1, "kg", "kg/m"},
                                       {"M c", 0, 1, 1, "N s", "N s/m"},
                                       {"M c/R", -1, 1, 1, "kg/s", "kg/(m s)"},
                                       {"M c²", 0, 2, 1, "J", "J/m"},
                                       {"M c²/R", -1, 2, 1, "N", "N/m"},
                                       {"M c²/R²", -2, 2, 1, "N/m", "Pa"}}};

void require_one(const RealDisk& disk, double RealDisk::*one, double RealDisk::*other,
                 const char* names) {
  const int given = static_cast<int>(is_given(disk.*one)) + static_cast<int>(is_given(disk.*other));
  if (given == 1) return;
  throw bad_value(names, given == 0 ? "nothing" : "both", "one of them");
}

}  // namespace

const std::vector<Parameter<RealDisk>>& real_disk_parameters() {
  using P = RealDisk;
  constexpr Interval kAny{0.0, 1e15, false};
  static const std::vector<Parameter<P>> table{
      real<P>(
          "radius", "m", kAny, "of the disk", [](auto& p) -> auto& { return p.radius; }),
      real<P>(
          "density", "kg/m³", kAny, "of the material, or the mass",
          [](auto& p) -> auto& { return p.density; }),
      real<P>(
          "mass", "kg", kAny, "of the disk, with its thickness",
          [](auto& p) -> auto& { return p.mass; }),
      real<P>(
          "young", "Pa", kAny, "Young's modulus E, or the wave speed",
          [](auto& p) -> auto& { return p.young; }),
      real<P>(
          "wave_speed", "m/s", kAny, "√(E/ρ), of long waves along a thin bar",
          [](auto& p) -> auto& { return p.wave_speed; }),
      real<P>(
          "thickness", "m", kAny, "of the disk; without it all is said for each metre of thickness",
          [](auto& p) -> auto& { return p.thickness; })};
  return table;
}

RealDisk parse_real_disk(const FlatTree& keys, const std::vector<std::string>& other_names) {
  RealDisk disk;
  read_parameters(real_disk_parameters(), keys, disk, other_names);
  if (!is_given(disk.radius)) throw bad_value("radius", "nothing", "number above 0, in m");
  require_one(disk, &RealDisk::density, &RealDisk::mass, "density and mass");
  require_one(disk, &RealDisk::young, &RealDisk::wave_speed, "young and wave_speed");
  if (is_given(disk.mass) && !is_given(disk.thickness)) {
    throw bad_value("thickness", "nothing", "number above 0, in m, where a mass is given");
  }
  return disk;
}

RealDisk parse_real_disk(const std::string& text) {
  FlatTree keys;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto [key, value] = parse_assignment(part, "key=value,key=value,…");
    if (!keys.emplace(key, parse_value(key, value)).second) {
      throw InputError(shown(key) + ": given twice");
    }
  }
  return parse_real_disk(keys);
}

SiUnits::SiUnits(const RealDisk& disk, const Scene& scene)
    : length_(disk.radius), per_metre_(!is_given(disk.thickness)) {
  const DiskElasticity lattice = disk_elasticity(scene, {});
  if (!is_given(lattice.young_modulus.value)) {
    throw InputError(
        "disk.file: the Young's modulus of this lattice is not known, so that its "
        "units have no value in SI");
  }
  const double volume = M_PI * disk.radius * disk.radius * (per_metre_ ? 1.0 : disk.thickness);
  mass_ = is_given(disk.mass) ? disk.mass : disk.density * volume;
  const double density = mass_ / volume;
  const double wave_speed =
      is_given(disk.wave_speed) ? disk.wave_speed : std::sqrt(disk.young / density);
  speed_ = wave_speed / std::sqrt(M_PI * lattice.young_modulus.value);
  origin_ = fmt::format(
      "R = {:.4g} m, E = {:.4g} Pa, ρ = {:.4g} kg/m³{}\n"
      "  the lattice: E = {:.4g} M c²/R², Poisson's ratio fixed near {}\n  ({})",
      disk.radius, density * wave_speed * wave_speed, density,
      per_metre_ ? ", for each metre of thickness"
                 : fmt::format(", {:.4g} m thick", disk.thickness),
      lattice.young_modulus.value, lattice.poisson_ratio.value, lattice.poisson_ratio.origin);
}

std::optional<Measure> SiUnits::in_si(double value, const std::string& unit) const {
  for (const Unit& known : kUnits) {
    if (unit != known.name) continue;
    return Measure{value * std::pow(length_, known.length) * std::pow(speed_, known.speed) *
                       std::pow(mass_, known.mass),
                   per_metre_ ? known.si_per_metre : known.si};
  }
  return std::nullopt;
}

}  // namespace impact
