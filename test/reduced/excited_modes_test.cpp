#include "reduced/excited_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_disk.hpp"

namespace impact {
namespace {

QuasiStaticContact pressed_contact(const SmallDisk& disk, double k_a) {
  QuasiStaticContact contact(disk.arm, disk.compliance, k_a, *disk.field.wall, 1e-12);
  contact.take({0.02 - disk.arm.col(1).minCoeff(), 0.0});
  return contact;
}

/// Lanczos's method keeps the moments of the load: Σ w = |P f|²/m and Σ w/ω² = fᵀ G f for a total
/// force of 1.
TEST(ExcitedModes, HaveTheMomentsOfTheLoad) {
  for (const double k_a : {1.0, 4.0}) {
    const SmallDisk disk(60, k_a);
    const QuasiStaticContact contact = pressed_contact(disk, k_a);
    const double force = contact.force();
    PointArray load = PointArray::Zero(120, 2);
    load.col(0) = contact.load() / force;
    disk.compliance->balance(load);
    double weights = 0.0;
    double compliance = 0.0;
    for (const ExcitedMode& mode : excited_modes(contact, 1.0 / 60.0)) {
      weights += mode.weight;
      compliance += mode.weight / (mode.frequency * mode.frequency);
    }
    EXPECT_NEAR(weights, 60.0 * load.col(0).square().sum(), 1e-9 * weights);
    EXPECT_NEAR(compliance, 2.0 * contact.bond_energy() / (force * force), 1e-9 * compliance);
  }
}

/// The slowest vibration of a disk has the frequency 2.7 c/R or so, a third of it in a triangle has
/// two modes only, which exhaust the load.
TEST(ExcitedModes, AreThoseOfTheBody) {
  const SmallDisk disk;
  double slowest = 1e9;
  for (const ExcitedMode& mode : excited_modes(pressed_contact(disk, 1.0), 1.0 / 60.0)) {
    slowest = std::min(slowest, mode.frequency);
  }
  EXPECT_GT(slowest, 2.2);
  EXPECT_LT(slowest, 3.4);
}

/// A pulse exp(−t²/2) has the Fourier transform √(2π) exp(−ω²/2), and leaves its square times the
/// weight over 2.
TEST(ExcitedModes, TakeEnergyFromAPulse) {
  std::vector<double> pulse;
  constexpr double kStep = 0.1;
  for (int k = -100; k <= 100; ++k) pulse.push_back(std::exp(-0.5 * k * k * kStep * kStep));
  for (const double frequency : {0.5, 1.0, 3.0}) {
    const double expected = 0.5 * 7.0 * 2.0 * M_PI * std::exp(-frequency * frequency);
    EXPECT_NEAR(energy_of_vibrations({{frequency, 7.0}}, pulse, kStep), expected, 1e-10 * expected);
  }
  EXPECT_EQ(energy_of_vibrations({{16.0, 7.0}}, pulse, kStep), 0.0);
}

}  // namespace
}  // namespace impact
