#include "run/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace impact {
namespace {

using Law = std::function<double(double)>;

/// Runs with steps 1.2 times shorter each, from coarse to fine; the true value is 1.
std::vector<Sample> runs_of(const Law& error, int count, double finest = 0.01) {
  std::vector<Sample> runs;
  for (int k = count - 1; k >= 0; --k) {
    const double step = finest * std::pow(1.2, k);
    runs.push_back({step, 1.0 + error(step)});
  }
  return runs;
}

double true_error(const ConvergedValue& result) { return std::abs(result.value - 1.0); }

/// Both powers are taken out, to rounding; 10⁻¹⁶ grows to some 10⁻¹⁵ by the weights of the runs.
TEST(Extrapolated, IsExactForTwoPowers) {
  for (const int order : {2, 6}) {
    const auto runs = runs_of(
        [order](double h) { return 3.0 * std::pow(h, order) - 70.0 * std::pow(h, order + 2); }, 3);
    EXPECT_NEAR(extrapolated(runs[0], runs[1], runs[2], order).value, 1.0, 1e-14);
  }
}

/// The true error is of the power after next, the estimate of the next: ten times the step makes it
/// grow by 10⁴ for order 2.
TEST(Extrapolated, EstimatesByTheNextPower) {
  const auto result = [](double finest) {
    const auto runs =
        runs_of([](double h) { return h * h + std::pow(h, 4) + std::pow(h, 6); }, 3, finest);
    return extrapolated(runs[0], runs[1], runs[2], 2);
  };
  EXPECT_NEAR(result(0.1).error / result(0.01).error, 1e4, 1e3);
  EXPECT_NEAR(true_error(result(0.1)) / true_error(result(0.03)), std::pow(10.0 / 3.0, 6), 20.0);
  EXPECT_LT(true_error(result(0.1)), result(0.1).error);
}

/// Without its h⁴ the limit of the finer two runs is off by B h_middle² h_fine², for A h² + B h⁴.
TEST(Extrapolated, DoubtsTheLimitByTwiceItsLastCorrection) {
  const auto runs = runs_of([](double h) { return h * h + 5.0 * std::pow(h, 4); }, 3);
  const double correction = 5.0 * std::pow(runs[1].step * runs[2].step, 2);
  // The weights of the runs let rounding of 10⁻¹⁶ grow to some 10⁻¹⁵.
  EXPECT_NEAR(extrapolated(runs[0], runs[1], runs[2], 2).error, 2.0 * correction, 1e-14);
}

/// A fourth run that agrees takes most of the doubt away: what it leaves is 0.05 of 0.15 of it
/// here, where the limits of both sets of three are exact.
TEST(Converged, DoubtsAConfirmedLimitLess) {
  const auto runs = runs_of([](double h) { return h * h + 5.0 * std::pow(h, 4); }, 4);
  const double alone = converged({runs.begin() + 1, runs.end()}, 2).error;
  EXPECT_NEAR(converged(runs, 2).error, 0.05 * 0.15 * alone, 1e-3 * alone);
}

/// Of errors in three powers the term that three runs leave out is the error of their limit.
TEST(Converged, DoubtsAConfirmedLimitByTheNextPower) {
  for (const int order : {2, 4}) {
    const auto runs = runs_of(
        [=](double h) {
          return std::pow(h / 0.1, order) * (1.0 + 5.0 * h * h + 400.0 * std::pow(h, 4));
        },
        4);
    const auto result = converged(runs, order);
    const double alone = converged({runs.begin() + 1, runs.end()}, order).error;
    EXPECT_NEAR(result.error, 3.0 * std::sqrt(true_error(result) * 0.15 * alone),
                1e-3 * result.error)
        << order;
  }
}

/// Limits that go on changing are in doubt by more than they are off; 10⁻⁷ is above what is left of
/// the doubt of h⁴.
TEST(Converged, DoubtsALimitThatChanges) {
  for (const double sixth : {-1e4, -1e3, 1e3, 1e4}) {
    const auto runs =
        runs_of([=](double h) { return h * h + 5.0 * std::pow(h, 4) + sixth * std::pow(h, 6); }, 4);
    const auto result = converged(runs, 2);
    EXPECT_GT(result.error, true_error(result)) << sixth;
    EXPECT_LT(result.error, 10.0 * true_error(result) + 1e-7) << sixth;
  }
}

/// Errors of A h: A (h_coarsest − h_finest) over h_coarsest/h_finest − 1 is that of the finest.
TEST(Compared, OfFirstOrderIsThreeTimesTheError) {
  const auto runs = runs_of([](double h) { return 0.1 * h; }, 4);
  EXPECT_NEAR(compared(runs, 1.0).error, 3.0 * 0.1 * 0.01, 1e-14);
  EXPECT_NEAR(compared_with_scatter(runs).error, 3.0 * 0.1 * 0.01, 1e-14);
}

TEST(Compared, OfAPowerIsThreeTimesItsError) {
  const auto runs = runs_of([](double h) { return 0.1 * h * h * h; }, 3);
  EXPECT_NEAR(compared(runs, 3.0).error, 3.0 * 0.1 * 1e-6, 1e-15);
}

/// Steps far apart take nothing off the range of values that scatter.
TEST(Compared, OfScatterIsThreeTimesTheRange) {
  const std::vector<Sample> runs{{0.1, 1.0}, {0.05, 1.3}, {0.01, 1.2}};
  EXPECT_DOUBLE_EQ(compared_with_scatter(runs).error, 3.0 * 0.3);
  EXPECT_DOUBLE_EQ(compared(runs, 1.0).error, 3.0 * 0.3 / 9.0);
}

/// Five runs are compared by half the order of their method if all of them fall so fast, and as
/// what scatters if one does not.
TEST(ComparedIfAllFall, GoesByTheFinestThreeOnlyIfAllDo) {
  for (const int order : {2, 6}) {
    for (const double power : {0.4, 0.6, 1.0, 2.0}) {
      const auto runs = runs_of([=](double h) { return std::pow(h / 0.02, power * order); }, 5);
      const ConvergedValue of_three = compared({runs.begin() + 2, runs.end()}, 0.5 * order);
      EXPECT_EQ(compared_if_all_fall(runs, order).error,
                power > 0.5 ? of_three.error : compared_with_scatter(runs).error);
      EXPECT_LT(true_error(of_three), of_three.error);
    }
  }
  for (std::size_t k = 0; k < 5; ++k) {
    auto runs = runs_of([](double h) { return std::pow(h / 0.01, 2); }, 5);
    runs[k].value += k == 0 ? -4.0 : 4.0;
    EXPECT_EQ(compared_if_all_fall(runs, 2).error, compared_with_scatter(runs).error) << k;
  }
}

/// Of a thousand sets of five values that scatter by as much as ±1, whatever the step, one in a
/// hundred at most is trusted too far; equal powers of the step would need all of them in order.
TEST(ComparedIfAllFall, IsSeldomMisledByScatter) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> scatter(-1.0, 1.0);
  constexpr int kDraws = 1000;
  int wrong = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const auto runs = runs_of([&](double /*h*/) { return scatter(random); }, 5);
    for (const int order : {2, 6}) {
      const ConvergedValue result = compared_if_all_fall(runs, order);
      wrong += true_error(result) > result.error ? 1 : 0;
    }
  }
  EXPECT_LE(wrong, 2 * kDraws / 100);
}

struct Sequence {
  const char* name;
  Law error;
};

class ConvergedOf : public testing::TestWithParam<Sequence> {};

/// Whatever the error does, the estimate of a method of order 2 or 6 covers it.
TEST_P(ConvergedOf, SequenceCoversItsError) {
  for (const int order : {2, 6}) {
    const auto result = converged(runs_of(GetParam().error, 3), order);
    constexpr double kRounding = 1e-15;
    EXPECT_LE(true_error(result), result.error + kRounding) << "order " << order;
    EXPECT_LE(result.error, 30.0 * std::abs(GetParam().error(0.0144))) << GetParam().name;
  }
}

/// 4.0 h² − h⁴ … in units of the finest step: equal errors of the two coarser runs, of all but the
/// middle one, and of the two finer ones.
Law with_turning_point(double squared) {
  return [squared](double h) {
    const double x = h * h / 1e-4;
    return 1e-5 * (squared * x - x * x);
  };
}

INSTANTIATE_TEST_SUITE_P(
    Error, ConvergedOf,
    testing::Values(Sequence{"right order", [](double h) { return 0.1 * h * h; }},
                    Sequence{"sixth order", [](double h) { return 1e6 * std::pow(h, 6); }},
                    Sequence{"a little less than order 2",
                             [](double h) { return 0.1 * std::pow(h, 1.8); }},
                    Sequence{"less than order 6", [](double h) { return 1e6 * std::pow(h, 5.8); }},
                    Sequence{"third power beside the second",
                             [](double h) { return 0.1 * h * h + 3.0 * h * h * h; }},
                    Sequence{"third order", [](double h) { return 10.0 * h * h * h; }},
                    Sequence{"first order", [](double h) { return 0.1 * h; }},
                    Sequence{"half order", [](double h) { return 0.1 * std::sqrt(h); }},
                    Sequence{"cancelling, coarse", with_turning_point(3.5136)},
                    Sequence{"cancelling, middle", with_turning_point(2.88)},
                    Sequence{"cancelling, fine", with_turning_point(2.44)}),
    [](const auto& info) {
      std::string name;
      for (const char c : std::string(info.param.name)) name += std::isalnum(c) ? c : '_';
      return name;
    });

/// Values that scatter by as much as ±1, whatever the step, in a thousand draws. Four that agree by
/// chance to a tenth of it come up in one of a thousand; three, of which an order may be seen, can
/// mislead in one of thirty: where values scatter, four are compared and no order is looked for.
TEST(Converged, ScatterIsSeldomTakenForAgreement) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> scatter(-1.0, 1.0);
  constexpr int kDraws = 1000;
  int wrong_of_three = 0;
  int wrong_of_four = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const auto runs = runs_of([&](double /*h*/) { return scatter(random); }, 4);
    const auto four = compared_with_scatter(runs);
    wrong_of_four += true_error(four) > four.error ? 1 : 0;
    const auto three = converged({runs.begin() + 1, runs.end()}, 2);
    wrong_of_three += true_error(three) > three.error ? 1 : 0;
  }
  EXPECT_LE(wrong_of_four, kDraws / 100);
  EXPECT_LE(wrong_of_three, kDraws / 10);
}

/// An order that the runs do not show is not used: the answer is that of the finest run.
TEST(Converged, DoesNotExtrapolateByAnOrderThatIsNotSeen) {
  const auto first = runs_of([](double h) { return 0.1 * h; }, 3);
  EXPECT_EQ(converged(first, 2).value, first.back().value);
  const auto second = runs_of([](double h) { return 0.1 * h * h; }, 3);
  EXPECT_EQ(converged(second, 6).value, second.back().value);
  EXPECT_NE(converged(second, 2).value, second.back().value);
}

/// An order p is seen from p − 0.25 to p + 0.5, and within 0.5 of p + 2.
TEST(Converged, TakesOnlyPowersNearTheOrderForIt) {
  for (const double power : {1.7, 1.8, 2.45, 2.6, 3.4, 3.6, 4.4, 4.6}) {
    const auto runs = runs_of([power](double h) { return std::pow(h / 0.1, power); }, 3);
    const bool is_near = (power > 1.75 && power < 2.5) || (power > 3.5 && power < 4.5);
    EXPECT_EQ(converged(runs, 2).value != runs.back().value, is_near) << power;
  }
}

/// Limits of four runs that themselves converge with order p differ by the error of the finer times
/// 1.2ᵖ − 1.
TEST(Converged, DoubtsTheLimitByThatOfTheCoarserRuns) {
  auto runs = runs_of([](double h) { return 0.1 * h * h; }, 4);
  runs.front().value += 1e-7;
  const double before = extrapolated(runs[0], runs[1], runs[2], 2).value;
  EXPECT_NEAR(converged(runs, 2).value, 1.0, 1e-14);
  EXPECT_NEAR(converged(runs, 2).error, std::abs(before - 1.0) / (1.2 * 1.2 - 1.0), 1e-13);
}

/// A last step that is much shorter does not make up for the longer ones which its limit rests on,
/// too: here a third power beside the second.
TEST(Converged, DoubtsTheLimitByAllItsSteps) {
  std::vector<Sample> runs;
  for (const double h : {0.0173, 0.0144, 0.012, 0.006})
    runs.push_back({h, 1.0 + h * h + h * h * h});
  const auto result = converged(runs, 2);
  EXPECT_NE(result.value, runs.back().value);
  EXPECT_LT(true_error(result), result.error);
}

/// Of a method of order 6 that shows another order: by the third power if the values fall so fast.
TEST(Converged, ComparesByHalfTheOrderWhereItIsSeen) {
  for (const double power : {2.9, 3.1, 5.0, 7.0, 9.0}) {
    const auto runs = runs_of([power](double h) { return std::pow(h / 0.02, power); }, 3);
    EXPECT_EQ(converged(runs, 6).error, compared(runs, power > 3.0 ? 3.0 : 1.0).error) << power;
  }
}

/// Three runs that show an order count if the three before them may show it too: here the coarsest
/// run is too coarse, and the other three agree with order 2 by themselves.
TEST(Converged, BelievesAnOrderThatWasNotSeenBeforeOnlyTwice) {
  // The latter makes the first power 0.6.
  for (const double off : {1.0, -3e-6}) {
    auto runs = runs_of([](double h) { return 0.1 * h * h; }, 5);
    runs[0].value += off;
    const std::vector<Sample> four(runs.begin(), runs.end() - 1);
    EXPECT_EQ(converged(four, 2).value, four.back().value);
    EXPECT_EQ(converged(four, 2).error, compared({four.begin() + 1, four.end()}, 1.0).error);
    const std::vector<Sample> next(runs.begin() + 1, runs.end());
    EXPECT_NEAR(converged(next, 2).value, 1.0, 1e-14);
  }
}

/// Powers of opposite signs, of which three runs show neither: four find the limit, and doubt it
/// three times as much as limits of first order.
TEST(Converged, FindsTheLimitOfPowersThatNearlyCancel) {
  const auto runs =
      runs_of([](double h) { return h * h - 600.0 * std::pow(h, 4) + 1e5 * std::pow(h, 6); }, 4);
  const std::vector<Sample> three(runs.begin() + 1, runs.end());
  EXPECT_EQ(converged(three, 2).value, three.back().value);
  EXPECT_TRUE(may_show_order(three[0], three[1], three[2], 2));
  const auto result = converged(runs, 2);
  const double before = extrapolated(runs[0], runs[1], runs[2], 2).value;
  EXPECT_NEAR(result.error, 3.0 * std::abs(result.value - before) / (1.2 - 1.0), 1e-15);
  EXPECT_LT(true_error(result), result.error);
  EXPECT_LT(result.error, 0.1 * converged(three, 2).error);
}

/// Errors of powers that the method should not have are covered by what four runs leave open; those
/// just below 2, which are taken for 2, to a fifth.
TEST(Converged, CoversOtherPowersByFourRuns) {
  for (const double ratio : {1.12, 1.2, 1.3}) {
    for (double power = 0.5; power < 5.0; power += 0.125) {
      std::vector<Sample> runs;
      for (int k = 3; k >= 0; --k) {
        const double step = std::pow(ratio, k);
        runs.push_back({step, 1.0 + std::pow(step, power)});
      }
      const auto result = converged(runs, 2);
      const double margin = power > 1.7 && power < 2.0 ? 1.2 : 1.0;
      EXPECT_LE(true_error(result), margin * result.error + 1e-12) << ratio << " " << power;
    }
  }
}

TEST(Converged, OfEqualRunsHasNoError) {
  const auto runs = runs_of([](double /*h*/) { return 0.0; }, 3);
  EXPECT_EQ(converged(runs, 2).value, 1.0);
  EXPECT_EQ(converged(runs, 2).error, 0.0);
}

}  // namespace
}  // namespace impact
