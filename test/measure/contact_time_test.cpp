#include "measure/contact_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

/// F = F₀ exp(−|t|/T): crosses 10⁻³ of its peak at ±T ln 1000, and is exponential in between.
ContactTime exponential_pulse(double peak_time, double range, double step) {
  ContactTime contact;
  for (int k = 0; k * step < 2.0 * peak_time; ++k) {
    const double time = k * step;
    contact.add({time, 2.0 * std::exp(-std::abs(time - peak_time) / range)});
  }
  return contact;
}

TEST(ContactTime, OfAnExponentialPulseIsExactWhateverTheStep) {
  for (const double step : {0.5, 0.25, 0.01}) {
    const ContactTime contact = exponential_pulse(20.0, 1.0, step);
    EXPECT_NEAR(contact.begin(), 20.0 - std::log(1000.0), 1e-12);
    EXPECT_NEAR(contact.end(), 20.0 + std::log(1000.0), 1e-12);
    EXPECT_NEAR(contact.duration(), 2.0 * std::log(1000.0), 1e-12);
    EXPECT_EQ(contact.peak_force(), 2.0);
  }
}

/// A first bump below the threshold of the later peak does not count, one above it does, and the
/// last bump ends the contact.
TEST(ContactTime, RunsFromTheFirstToTheLastCrossing) {
  ContactTime contact;
  const double forces[] = {0, 5e-4, 0, 0.1, 0, 1, 0, 0.5, 0, 1e-4, 0};
  for (int k = 0; k < 11; ++k) contact.add({static_cast<double>(k), forces[k]});
  EXPECT_NEAR(contact.begin(), 2.01, 1e-12);  // linear where the force starts from zero
  EXPECT_NEAR(contact.end(), 8.0 - 0.002, 1e-12);
}

TEST(ContactTime, IsUnknownWithoutContactAndWhileItLasts) {
  ContactTime contact;
  EXPECT_TRUE(std::isnan(contact.begin()));
  EXPECT_TRUE(std::isnan(contact.peak_force()));
  contact.add({0.0, 0.0});
  EXPECT_TRUE(std::isnan(contact.begin()));
  contact.add({1.0, 1.0});
  EXPECT_NEAR(contact.begin(), 0.001, 1e-15);
  EXPECT_TRUE(std::isnan(contact.end()));
  contact.add({2.0, 0.0});
  EXPECT_NEAR(contact.end(), 2.0 - 0.001, 1e-15);
}

TEST(ContactTime, OfAContactThatIsThereAtTheStart) {
  ContactTime contact;
  contact.add({0.0, 1.0});
  contact.add({1.0, 0.0});
  EXPECT_EQ(contact.begin(), 0.0);
  EXPECT_NEAR(contact.end(), 1.0 - 0.001, 1e-15);
}

}  // namespace
}  // namespace impact
