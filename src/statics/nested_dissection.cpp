#include "statics/nested_dissection.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>

namespace impact {
namespace {

using Numbers = std::vector<std::int32_t>;
using Range = std::pair<Numbers::iterator, Numbers::iterator>;

constexpr std::int32_t kFewestToHalve = 12;  // fewer are eliminated together
constexpr std::int32_t kSeparates = -1;
constexpr double kSmallestHalf = 0.4;  // of the points
constexpr int kPushes = 8;             // each way; more gain nothing

/// Across which ranges are cut.
constexpr std::array<std::array<double, 2>, 4> kDirections{
    {{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}};

/// Halves ranges of points.
class Halving {
 public:
  Halving(const PointArray& position, const Couplings& couplings)
      : position_(position),
        couplings_(couplings),
        mark_(static_cast<std::size_t>(position.rows()), 0) {}

  /// Moves the points of a range so that the halves stand first and what separates them last: where
  /// each of the last two begins.
  Range halve(const Range& range);

 private:
  struct Half {
    std::int32_t mark;  ///< of no other half before
    std::ptrdiff_t points;
  };

  void cut(const Range& range);
  void cut(const Range& range, const std::array<double, 2>& direction);
  void push(Half& smaller, Half& larger, std::ptrdiff_t least);
  std::int32_t& mark_of(std::int32_t point) { return mark_[static_cast<std::size_t>(point)]; }

  const PointArray& position_;
  const Couplings& couplings_;
  Numbers mark_;  ///< of each point that of its half, or kSeparates
  std::array<Half, 2> halves_{};
  Numbers separator_;
};

/// At the median along a direction.
void Halving::cut(const Range& range, const std::array<double, 2>& direction) {
  const auto height = [&](std::int32_t point) {
    return std::make_pair(position_(point, 0) * direction[0] + position_(point, 1) * direction[1],
                          point);
  };
  const auto half = range.first + (range.second - range.first) / 2;
  std::nth_element(range.first, half, range.second,
                   [&](std::int32_t a, std::int32_t b) { return height(a) < height(b); });
  const std::int32_t mark = std::max(halves_[0].mark, halves_[1].mark) + 1;
  halves_ = {Half{mark, half - range.first}, Half{mark + 1, range.second - half}};
  std::for_each(range.first, half, [&](std::int32_t point) { mark_of(point) = mark; });
  std::for_each(half, range.second, [&](std::int32_t point) { mark_of(point) = mark + 1; });
  separator_.clear();
  std::copy_if(range.first, half, std::back_inserter(separator_), [&](std::int32_t point) {
    return std::any_of(couplings_.begin(point), couplings_.end(point),
                       [&](std::int32_t other) { return mark_of(other) == mark + 1; });
  });
}

/// Along the direction that leaves the fewest points between the halves.
void Halving::cut(const Range& range) {
  std::array<std::size_t, 4> count{};
  for (std::size_t k = 0; k < count.size(); ++k) {
    cut(range, kDirections[k]);
    count[k] = separator_.size();
  }
  const auto best = std::min_element(count.begin(), count.end()) - count.begin();
  cut(range, kDirections[static_cast<std::size_t>(best)]);
  halves_[0].points -= static_cast<std::ptrdiff_t>(separator_.size());
  for (const std::int32_t point : separator_) mark_of(point) = kSeparates;
}

/// Lets each separating point that couples to at most one point of a half go to the other half, for
/// that one point: the number of separating points falls or stays, and their line grows shorter.
void Halving::push(Half& smaller, Half& larger, std::ptrdiff_t least) {
  for (std::size_t k = 0; k < separator_.size();) {
    const std::int32_t point = separator_[k];
    const auto in_smaller = [&](std::int32_t other) { return mark_of(other) == smaller.mark; };
    const auto* const coupled =
        std::find_if(couplings_.begin(point), couplings_.end(point), in_smaller);
    const auto count = std::count_if(coupled, couplings_.end(point), in_smaller);
    if (count > 1 || smaller.points - count < least) {
      ++k;
      continue;
    }
    mark_of(point) = larger.mark;
    ++larger.points;
    smaller.points -= count;
    if (count == 1) {
      separator_[k] = *coupled;
      mark_of(*coupled) = kSeparates;
      ++k;
    } else {
      separator_[k] = separator_.back();
      separator_.pop_back();
    }
  }
}

Range Halving::halve(const Range& range) {
  cut(range);
  const auto least =
      static_cast<std::ptrdiff_t>(kSmallestHalf * static_cast<double>(range.second - range.first));
  for (int k = 0; k < kPushes; ++k) push(halves_[1], halves_[0], least);
  for (int k = 0; k < kPushes; ++k) push(halves_[0], halves_[1], least);
  const auto is_in = [this](const Half& half) {
    return [this, &half](std::int32_t point) { return mark_of(point) == half.mark; };
  };
  const auto second = std::partition(range.first, range.second, is_in(halves_[0]));
  return {second, std::partition(second, range.second, is_in(halves_[1]))};
}

/// Adds the parts of a range, each after those below it. The last one's number.
std::int32_t add_parts(const Range& range, Halving& halving, Dissection& dissection) {
  const auto place = [&](Numbers::iterator at) {
    return static_cast<std::int32_t>(at - dissection.order.begin());
  };
  Dissection::Part part{place(range.first), place(range.second), {}};
  if (range.second - range.first >= kFewestToHalve) {
    const auto [second, separator] = halving.halve(range);
    part.first = place(separator);
    part.children.push_back(add_parts({range.first, second}, halving, dissection));
    part.children.push_back(add_parts({second, separator}, halving, dissection));
  }
  dissection.parts.push_back(std::move(part));
  return static_cast<std::int32_t>(dissection.parts.size()) - 1;
}

}  // namespace

Couplings::Couplings(const Eigen::SparseMatrix<double>& matrix, std::int32_t points)
    : first_(static_cast<std::size_t>(points) + 1, 0) {
  const auto for_each_end = [&](const auto& visit) {
    for (std::int32_t column = 0; column < points; ++column) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
        const auto row = static_cast<std::int32_t>(entry.row());
        if (row >= points || row == column) continue;
        visit(row, column);
        visit(column, row);
      }
    }
  };
  for_each_end([&](std::int32_t end, std::int32_t) { ++first_[static_cast<std::size_t>(end)]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  others_.resize(static_cast<std::size_t>(first_.back()));
  for_each_end([&](std::int32_t end, std::int32_t other) {
    others_[static_cast<std::size_t>(--first_[static_cast<std::size_t>(end)])] = other;
  });
}

Dissection dissect(const PointArray& position, const Couplings& couplings) {
  Dissection dissection;
  dissection.order.resize(static_cast<std::size_t>(position.rows()));
  std::iota(dissection.order.begin(), dissection.order.end(), 0);
  Halving halving(position, couplings);
  add_parts({dissection.order.begin(), dissection.order.end()}, halving, dissection);
  return dissection;
}

}  // namespace impact
