#include "verification/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace impact {

std::vector<std::size_t> pareto_front(const std::vector<WorkAndError>& points) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!std::isnan(points[k].error)) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].work != points[b].work ? points[a].work < points[b].work
                                            : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  double least_error = std::numeric_limits<double>::infinity();
  for (const std::size_t k : order) {
    if (points[k].error >= least_error) continue;
    least_error = points[k].error;
    front.push_back(k);
  }
  return front;
}

std::optional<std::size_t> least_work(const std::vector<WorkAndError>& points, double error) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool good = points[k].error <= error;
    if (good && (!best || points[k].work < points[*best].work)) best = k;
  }
  return best;
}

std::optional<std::size_t> coarsest_sufficient(const std::vector<double>& errors, double error) {
  std::size_t first = errors.size();
  while (first > 0 && errors[first - 1] <= error) --first;
  return first < errors.size() ? std::optional(first) : std::nullopt;
}

}  // namespace impact
