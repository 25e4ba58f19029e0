#include "measure/contact_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

/// F = exp(t − eᵗ), the largest at t = 0, steep on one side: in error by powers of the step,
/// wherever the steps fall.
TEST(ContactTime, OfASmoothPulseConvergesWhateverThePhase) {
  // t − eᵗ = −1 − ln 1000
  const double begin = -7.9073872641309535;
  const double end = 2.3256581974694486;
  const auto log_of = [](double t) { return t - std::exp(t); };
  ASSERT_NEAR(log_of(begin), -1.0 - std::log(1000.0), 1e-8);
  ASSERT_NEAR(log_of(end), -1.0 - std::log(1000.0), 1e-8);
  struct Errors {
    double peak, begin, end;
  };
  const auto errors = [&](double step) {
    Errors largest{};
    for (double phase = 0.0; phase < 1.0; phase += 0.1) {
      ContactTime contact;
      for (double t = -10.0 + phase * step; t < 3.0; t += step) {
        contact.add({t, std::exp(log_of(t))});
      }
      largest.peak = std::max(largest.peak, std::abs(contact.peak_force() - std::exp(-1.0)));
      largest.begin = std::max(largest.begin, std::abs(contact.begin() - begin));
      largest.end = std::max(largest.end, std::abs(contact.end() - end));
    }
    return largest;
  };
  const Errors coarse = errors(0.1);
  const Errors fine = errors(0.05);
  EXPECT_LT(fine.peak, 1e-5);
  EXPECT_LT(fine.begin, 1e-5);  // by that of the peak
  EXPECT_LT(fine.end, 1e-6);
  EXPECT_GT(coarse.peak, 7.0 * fine.peak);  // power 3
  EXPECT_GT(coarse.begin, 7.0 * fine.begin);
  EXPECT_GT(coarse.end, 7.0 * fine.end);
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

/// Messages may be damaged: a time comes out, whatever it is worth.
TEST(ContactTime, EndsOfSamplesOutOfOrder) {
  for (const double way : {-1.0, 0.0}) {
    ContactTime contact;
    double time = 0.0;
    for (const double force : {1e-6, 1e-5, 1.0, 2.0, 1.0, 1e-5, 1e-6}) {
      contact.add({time, force});
      time += way;
    }
    EXPECT_NO_THROW(contact.begin()) << way;
    EXPECT_NO_THROW(contact.end()) << way;
  }
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
