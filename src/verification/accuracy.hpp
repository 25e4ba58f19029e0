#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "verification/reference_answer.hpp"

namespace impact {

/// What came of one scene with its wanted error.
struct AccuracyTrial {
  static constexpr const char* kAnswered = "answered";

  std::string status;  ///< kAnswered, or why not
  std::string integrator;
  double step;
  double answer;
  double estimated_error;
  double wall_time;  ///< s
};

/// Computes the answer as the program `impact` does. Whatever is thrown becomes the status, as does
/// work beyond about a minute: 10⁹ points times force evaluations.
AccuracyTrial try_scene(const Scene& scene);

/// A scene, its answer and the reference.
struct AccuracyCheck {
  Scene scene;
  int rejected = 0;  ///< scenes drawn before it, see RandomScene
  ReferenceAnswer reference;
  AccuracyTrial trial;

  bool answered() const { return trial.status == AccuracyTrial::kAnswered; }
  /// Of the answer, relative to the reference.
  double true_error() const;
};

/// What the reference says of an answer.
enum class Verdict {
  kKept,         ///< it errs by no more than the wanted error
  kBroken,       ///< it errs by more, and by far more than a poor reference may
  kUndefined,    ///< references differ by more than the wanted error
  kNoReference,  ///< there is no reference to a tenth of the wanted error
  kRefused       ///< there is no answer
};
Verdict verdict(const AccuracyCheck& check);
std::string name_of(Verdict verdict);

/// The true over the estimated error of an answer, where the reference is good enough to say
/// whether it lies between 1/100 and 100; else NaN.
double true_over_estimated(const AccuracyCheck& check);

/// How good the estimated errors of the answers are.
struct EstimateQuality {
  std::vector<double> ratios;  ///< true_over_estimated() where known, rising
  int within = 0;              ///< of them between 1/100 and 100
  int unknown = 0;             ///< answers of which it is not known
};
EstimateQuality estimate_quality(const std::vector<AccuracyCheck>& checks);

/// The true over the wanted errors of the answers with a reference, rising.
std::vector<double> errors_over_wanted(const std::vector<AccuracyCheck>& checks);

/// How many scenes have each verdict.
std::map<Verdict, int> count_verdicts(const std::vector<AccuracyCheck>& checks);

/// How often there was no answer, by cause: the status with # for each number.
std::map<std::string, int> count_refusals(const std::vector<AccuracyCheck>& checks);

}  // namespace impact
