#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace impact {

/// What an answer costs, and how far off it is. An error of NaN: there is no answer.
struct WorkAndError {
  double work = 0.0;
  double error = 0.0;
};

/// The indices of the points that no other one beats, being as good in one and better in the other,
/// in the order of rising work. Of equal points the first.
std::vector<std::size_t> pareto_front(const std::vector<WorkAndError>& points);

/// The index of the point of least work whose error is not above this one.
std::optional<std::size_t> least_work(const std::vector<WorkAndError>& points, double error);

/// Of the errors of ever finer settings: the index of the coarsest setting from which on none is
/// above `error`. A coarser one that is good by chance does not count.
std::optional<std::size_t> coarsest_sufficient(const std::vector<double>& errors, double error);

}  // namespace impact
