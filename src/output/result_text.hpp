#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/result.hpp"
#include "output/si_units.hpp"
#include "scene/parameter_table.hpp"
#include "scene/scene.hpp"

/// Results as people read them, and as programs do.
namespace impact {

/// The value with the digits that its error allows; six where the error is not known (NaN or 0).
std::string digits(double value, double error);

/// A result by the keys under which impact and analyse_bag give it: a line a number with its error,
/// its unit and, with `si`, its value in SI, then the flags with a few words each.
std::string result_block(const Result& result, const Scene& scene,
                         const std::optional<SiUnits>& si = std::nullopt);

/// The results of a series by the same keys, a line a run.
std::string result_table(const std::vector<Result>& results, SceneKind kind);

/// "collision at 0.01 c, 1099 points, seed 1".
std::string title(const Scene& scene);

/// Those numbers of the result that have a unit, in SI, and the units by the same keys.
YAML::Node si_values(const Result& result, const Scene& scene, const SiUnits& si);

/// The tree as JSON; numbers that are not finite are null.
std::string to_json(const YAML::Node& tree);

}  // namespace impact
