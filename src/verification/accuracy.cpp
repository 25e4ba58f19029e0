#include "verification/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <regex>

#include "scene/scene_parameters.hpp"
#include "series/convergence_study.hpp"

namespace impact {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostWorkOfAnswer = 1e9;  // points times force evaluations
constexpr double kKnown = 0.1;             // of the wanted error, what the reference may err by
/// Times the error of a poor reference: what an answer must be off to be certainly wrong.
constexpr double kCertain = 10.0;
constexpr double kFactor = 100.0;

/// Adds up the work of all runs of a study.
class WorkMeter {
 public:
  void look(const Run& run) {
    const std::uint64_t evaluations = run.system().field().evaluations;
    const std::uint64_t more = evaluations < last_ ? evaluations : evaluations - last_;
    last_ = evaluations;
    work_ += static_cast<double>(more) * static_cast<double>(run.state().position.rows());
  }
  bool is_too_much() const { return work_ > kMostWorkOfAnswer; }

 private:
  std::uint64_t last_ = 0;
  double work_ = 0.0;
};

void perform(ConvergenceStudy& study) {
  WorkMeter meter;
  const auto stop = [&] {
    meter.look(study.run());
    return meter.is_too_much();
  };
  while (!study.finished()) {
    study.advance(stop);
    if (meter.is_too_much()) throw RunFailure("stopped: too much work");
  }
  for (const Flag flag : {Flag::kNotAtRest, Flag::kNotSeparated}) {
    if (study.run().has_flag(flag)) throw RunFailure(name_of(flag));
  }
}

bool is_within(double ratio) { return ratio >= 1.0 / kFactor && ratio <= kFactor; }

std::string cause_of(const std::string& status) {
  static const std::regex number(R"([-+]?\d+(\.\d+)?([eE][-+]?\d+)?)");
  return std::regex_replace(status, number, "#");
}

}  // namespace

AccuracyTrial try_scene(const Scene& scene) {
  AccuracyTrial trial{AccuracyTrial::kAnswered, "", kUnknown, kUnknown, kUnknown, kUnknown};
  try {
    ConvergenceStudy study(scene);
    perform(study);
    trial.integrator = name_of(study.run().integrator());
    trial.step = study.run().system().step_size();
    trial.answer = study.answer();
    trial.estimated_error = study.estimated_error();
    trial.wall_time = study.wall_time();
  } catch (const std::exception& failure) {
    trial.status = failure.what();
  }
  return trial;
}

double AccuracyCheck::true_error() const { return std::abs(trial.answer / reference.value - 1.0); }

Verdict verdict(const AccuracyCheck& check) {
  const double wanted = check.scene.numerics.error;
  const double doubt = check.reference.error;
  if (!check.answered()) return Verdict::kRefused;
  if (std::isinf(doubt)) return Verdict::kNoReference;
  const bool known = doubt <= kKnown * wanted;
  if (!(check.true_error() <= wanted + (known ? doubt : kCertain * doubt))) return Verdict::kBroken;
  if (known) return Verdict::kKept;
  return doubt > wanted ? Verdict::kUndefined : Verdict::kNoReference;
}

std::string name_of(Verdict verdict) {
  static const std::map<Verdict, std::string> names{{Verdict::kKept, "kept"},
                                                    {Verdict::kBroken, "broken"},
                                                    {Verdict::kUndefined, "undefined"},
                                                    {Verdict::kNoReference, "no reference"},
                                                    {Verdict::kRefused, "refused"}};
  return names.at(verdict);
}

double true_over_estimated(const AccuracyCheck& check) {
  if (!check.answered()) return kUnknown;
  const double ratio = check.true_error() / check.trial.estimated_error;
  const double doubt = check.reference.error / check.trial.estimated_error;
  const double low = ratio - doubt;
  const double high = ratio + doubt;
  const bool outside = high < 1.0 / kFactor || low > kFactor;
  return outside || (is_within(low) && is_within(high)) ? ratio : kUnknown;
}

EstimateQuality estimate_quality(const std::vector<AccuracyCheck>& checks) {
  EstimateQuality quality;
  for (const AccuracyCheck& check : checks) {
    const double ratio = true_over_estimated(check);
    if (std::isnan(ratio)) {
      quality.unknown += check.answered() ? 1 : 0;
      continue;
    }
    quality.ratios.push_back(ratio);
    quality.within += is_within(ratio) ? 1 : 0;
  }
  std::sort(quality.ratios.begin(), quality.ratios.end());
  return quality;
}

std::vector<double> errors_over_wanted(const std::vector<AccuracyCheck>& checks) {
  std::vector<double> errors;
  for (const AccuracyCheck& check : checks) {
    const Verdict said = verdict(check);
    if (said != Verdict::kKept && said != Verdict::kBroken) continue;
    errors.push_back(check.true_error() / check.scene.numerics.error);
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

std::map<Verdict, int> count_verdicts(const std::vector<AccuracyCheck>& checks) {
  std::map<Verdict, int> counts;
  for (const AccuracyCheck& check : checks) ++counts[verdict(check)];
  return counts;
}

std::map<std::string, int> count_refusals(const std::vector<AccuracyCheck>& checks) {
  std::map<std::string, int> counts;
  for (const AccuracyCheck& check : checks) {
    if (!check.answered()) ++counts[cause_of(check.trial.status)];
  }
  return counts;
}

}  // namespace impact
