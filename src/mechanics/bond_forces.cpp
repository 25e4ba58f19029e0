#include "mechanics/bond_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace impact {

namespace {

/// Where the pair of a point begins.
std::int32_t pair_of(std::int32_t point) { return 2 * point; }

}  // namespace

BondForces::BondForces(const Lattice& lattice, const BondLaw& law, const Kernels& kernels)
    : law_(law),
      kernels_(&kernels),
      table_(table_of(lattice)),
      part_sums_(static_cast<std::size_t>(parts_of(table_->points)), 0.0) {}

std::shared_ptr<const BondForces::Table> BondForces::table_of(const Lattice& lattice) {
  const Eigen::Index points = lattice.points.rows();
  std::vector<std::int32_t> bonds_of(static_cast<std::size_t>(kSlice * whole_slices(points)), 0);
  for (const Bond& bond : lattice.bonds) {
    ++bonds_of[static_cast<std::size_t>(bond.first)];
    ++bonds_of[static_cast<std::size_t>(bond.second)];
  }
  auto table = std::make_shared<Table>();
  table->points = points;
  table->begin.push_back(0);
  for (auto slice = bonds_of.begin(); slice != bonds_of.end(); slice += kSlice) {
    table->begin.push_back(table->begin.back() + *std::max_element(slice, slice + kSlice));
  }

  const std::size_t places = static_cast<std::size_t>(table->begin.back()) * kSlice;
  table->end.resize(places);
  table->natural_length.assign(places, 0.0);
  for (std::size_t slice = 0; slice + 1 < table->begin.size(); ++slice) {
    const auto row_of = [&](std::size_t s) { return static_cast<std::size_t>(table->begin[s]); };
    for (std::size_t row = row_of(slice); row < row_of(slice + 1); ++row) {
      const auto places_of_row = table->end.begin() + static_cast<std::ptrdiff_t>(row * kSlice);
      for (int k = 0; k < kSlice; ++k) {
        places_of_row[k] = pair_of(static_cast<std::int32_t>(slice) * kSlice + k);
      }
    }
  }
  std::fill(bonds_of.begin(), bonds_of.end(), 0);
  const auto enter = [&](std::int32_t point, std::int32_t other, double natural_length) {
    const std::int64_t row = table->begin[static_cast<std::size_t>(point / kSlice)] +
                             bonds_of[static_cast<std::size_t>(point)]++;
    const auto place = static_cast<std::size_t>(row * kSlice + point % kSlice);
    table->end[place] = pair_of(other);
    table->natural_length[place] = natural_length;
  };
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Bond& bond = lattice.bonds[k];
    enter(bond.first, bond.second, lattice.natural_lengths[k]);
    enter(bond.second, bond.first, lattice.natural_lengths[k]);
  }
  table->needed = parts_needed(*table);
  return table;
}

PartsNeeded BondForces::parts_needed(const Table& table) {
  const auto parts = static_cast<std::size_t>(parts_of(table.points));
  const auto last = static_cast<std::int32_t>(table.points - 1);  // empty places may lie behind it
  PartsNeeded needed{std::vector<Eigen::Index>(parts), std::vector<Eigen::Index>(parts)};
  for (std::size_t part = 0; part < parts; ++part) {
    const auto part_number = static_cast<Eigen::Index>(part);
    const PointRows rows = rows_of_part(part_number, table.points);
    const auto place_of = [&](Eigen::Index slice) {
      return table.end.begin() +
             Eigen::Index{kSlice} * table.begin[static_cast<std::size_t>(slice)];
    };
    const auto [least, most] = std::minmax_element(place_of(rows.first / kSlice),
                                                   place_of(whole_slices(rows.first + rows.size)));
    needed.begin[part] = std::min<Eigen::Index>(*least / 2 / kPart, part_number);
    needed.end[part] = std::max<Eigen::Index>(std::min(*most / 2, last) / kPart, part_number) + 1;
  }
  for (std::size_t part = 1; part < parts; ++part) {
    needed.end[part] = std::max(needed.end[part], needed.end[part - 1]);
    const std::size_t other = parts - 1 - part;
    needed.begin[other] = std::min(needed.begin[other], needed.begin[other + 1]);
  }
  return needed;
}

BondForces BondForces::of_two_laws(BondForces first, BondForces second) {
  first.second_.push_back(std::move(second));
  first.order_ = std::make_shared<OrderOnDemand>();
  return first;
}

const EliminationOrder& BondForces::elimination_order() const {
  std::call_once(order_->once, [this] {
    const std::vector<Eigen::Triplet<double>> entries = damping();
    Eigen::SparseMatrix<double> matrix(points(), points());
    matrix.setFromTriplets(entries.begin(), entries.end());
    order_->order = impact::elimination_order(matrix);
  });
  return order_->order;
}

BondForces BondForces::with(const BondLaw& law) const {
  BondForces changed = *this;
  changed.law_ = law;
  return changed;
}

void BondForces::make_room(Aligned<double>& pairs) const {
  pairs.resize(static_cast<std::size_t>(Eigen::Index{2} * kSlice * table_->slices()), 0.0);
}

void BondForces::pair_up(const PointArray& points, const PointRows& rows,
                         Aligned<double>& pairs) const {
  kernels_->pair_up(&points(rows.first, 0), &points(rows.first, 1), rows.size,
                    pairs.data() + 2 * rows.first);
}

void BondForces::pair_up(const PointArray& points, Aligned<double>& pairs) const {
  make_room(pairs);
  in_parts(table_->points, [&](Eigen::Index /*part*/, Eigen::Index first, Eigen::Index size) {
    pair_up(points, {first, size}, pairs);
  });
}

/// Where an argument is nullptr, its forces are not evaluated.
BondKernel BondForces::kernel(const PointArray* position, const PointArray* velocity) const {
  if (position == nullptr) return kernels_->damping;
  const bool cubic = law_.k_b != 0.0;
  if (velocity != nullptr) return cubic ? kernels_->cubic_damped : kernels_->linear_damped;
  return cubic ? kernels_->cubic : kernels_->linear;
}

BondEvaluation BondForces::evaluation_of(PointArray& force) const {
  return {{table_->begin.data(), table_->end.data(), table_->natural_length.data()},
          law_.k_a,
          law_.k_b,
          law_.eta,
          force.rows(),
          position_pairs_.data(),
          velocity_pairs_.data(),
          force.data()};
}

/// What the last slice writes behind the first body's rows is overwritten by the second's.
double BondForces::evaluate_first(const PointArray* position, const PointArray* velocity,
                                  PointArray& force) {
  if (!first_is_damped()) velocity = nullptr;
  if (position == nullptr && velocity == nullptr) {
    force.topRows(table_->points).setZero();
    return 0.0;
  }
  if (position != nullptr) pair_up(*position, position_pairs_);
  if (velocity != nullptr) pair_up(*velocity, velocity_pairs_);
  const BondEvaluation evaluation = evaluation_of(force);
  static_assert(kPart % kSlice == 0);
  in_parts(table_->points, [&](Eigen::Index part, Eigen::Index first, Eigen::Index size) {
    part_sums_[static_cast<std::size_t>(part)] =
        kernel(position, velocity)(evaluation, first / kSlice, whole_slices(first + size));
  });
  return 0.5 * law_.eta * std::accumulate(part_sums_.begin(), part_sums_.end(), 0.0);
}

double BondForces::evaluate_second(const PointArray* position, const PointArray* velocity,
                                   PointArray& force) {
  BondForces& second = second_.front();
  const Eigen::Index rows = second.points();
  const auto take = [&](const PointArray* all, PointArray& own) -> const PointArray* {
    if (all == nullptr) return nullptr;
    own = all->bottomRows(rows);
    return &own;
  };
  of_second_.force.resize(rows, 2);
  const double power = second.evaluate_first(take(position, of_second_.position),
                                             take(velocity, of_second_.velocity), of_second_.force);
  force.bottomRows(rows) = of_second_.force;
  return power;
}

double BondForces::evaluate_all(const PointArray* position, const PointArray* velocity,
                                PointArray& force) {
  const double power = evaluate_first(position, velocity, force);
  return has_two_laws() ? power + evaluate_second(position, velocity, force) : power;
}

template <class Use>
void BondForces::for_each_end(Eigen::Index first, Eigen::Index end, const Use& use) const {
  for (Eigen::Index i = first; i < end; ++i) {
    const auto slice = static_cast<std::size_t>(i / kSlice);
    for (std::int32_t row = table_->begin[slice]; row < table_->begin[slice + 1]; ++row) {
      const auto place = static_cast<std::size_t>(std::int64_t{row} * kSlice + i % kSlice);
      const std::int32_t j = table_->end[place] / 2;
      if (j != i) use(static_cast<std::int32_t>(i), j, table_->natural_length[place]);
    }
  }
}

template <class Use>
void BondForces::for_each_bond(const Use& use) const {
  for_each_end(0, table_->points, [&](std::int32_t i, std::int32_t j, double natural_length) {
    if (j > i) use(i, j, natural_length);
  });
}

double BondForces::potential_energy(const PointArray& position, Eigen::Index first,
                                    Eigen::Index end) const {
  double of_second = 0.0;
  if (has_two_laws() && end > table_->points) {
    const BondForces& second = second_.front();
    of_second = second.potential_energy(position.bottomRows(second.points()),
                                        std::max<Eigen::Index>(0, first - table_->points),
                                        end - table_->points);
    end = table_->points;
  }
  const Elongations twice = elongations_at(position, first, end);
  return of_second + law_.k_a * twice.squared / 4.0 + law_.k_b * twice.to_the_fourth / 8.0;
}

/// Of all bonds of the points first … end − 1, once for each of their ends there.
Elongations BondForces::elongations_at(const PointArray& position, Eigen::Index first,
                                       Eigen::Index end) const {
  Aligned<double> pairs;
  pair_up(position, pairs);
  const BondRows rows{table_->begin.data(), table_->end.data(), table_->natural_length.data()};
  const Eigen::Index first_slice = whole_slices(first);
  const Eigen::Index end_slice = end == table_->points ? whole_slices(end) : end / kSlice;
  std::vector<Elongations> parts(static_cast<std::size_t>(parts_of(table_->points)));
  in_parts(table_->points, [&](Eigen::Index part, Eigen::Index point, Eigen::Index size) {
    parts[static_cast<std::size_t>(part)] =
        kernels_->elongations(rows, pairs.data(), std::max(point / kSlice, first_slice),
                              std::min(whole_slices(point + size), end_slice));
  });
  Elongations sum;
  const auto add = [&](std::int32_t i, std::int32_t j, double natural_length) {
    const double length = (position.row(i) - position.row(j)).matrix().norm();
    const double squared = std::pow(length - natural_length, 2);
    sum.squared += squared;
    sum.to_the_fourth += squared * squared;
  };
  for_each_end(first, std::min(end, kSlice * first_slice), add);
  for_each_end(kSlice * std::max(first_slice, end_slice), end, add);
  for (const Elongations& part : parts) {
    sum.squared += part.squared;
    sum.to_the_fourth += part.to_the_fourth;
  }
  return sum;
}

std::vector<Eigen::Triplet<double>> BondForces::stiffness(const PointArray& position) const {
  std::vector<Eigen::Triplet<double>> entries;
  find_stiffness(position, entries);
  return entries;
}

void BondForces::find_stiffness(const PointArray& position,
                                std::vector<Eigen::Triplet<double>>& entries) const {
  const auto points = static_cast<std::int32_t>(position.rows());
  // What other terms may add, one a coordinate, too: growing would copy them all.
  entries.reserve(8 * table_->end.size() + 2 * static_cast<std::size_t>(points) + 2);
  entries.resize(8 * table_->end.size());  // which has some empty places
  auto entry = entries.begin();
  for_each_bond([&](std::int32_t i, std::int32_t j, double natural_length) {
    const Eigen::Vector2d offset = (position.row(i) - position.row(j)).matrix().transpose();
    const double length = offset.norm();
    const Eigen::Vector2d normal = offset / length;
    const double x = length - natural_length;
    const double along = law_.k_a + 3.0 * law_.k_b * x * x;
    const double across = (law_.k_a * x + law_.k_b * x * x * x) / length;
    const Eigen::Matrix2d projection = normal * normal.transpose();
    const Eigen::Matrix2d block =
        along * projection + across * (Eigen::Matrix2d::Identity() - projection);
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 2; ++column) {
        const double value = block(row, column);
        *entry++ = {row * points + i, column * points + i, value};
        *entry++ = {row * points + j, column * points + j, value};
        *entry++ = {row * points + i, column * points + j, -value};
        *entry++ = {row * points + j, column * points + i, -value};
      }
    }
  });
  entries.resize(static_cast<std::size_t>(entry - entries.begin()));
  if (!has_two_laws()) return;
  const auto first_points = static_cast<std::int32_t>(table_->points);
  const std::int32_t of_second = points - first_points;
  const auto place = [&](int k) {
    return k < of_second ? first_points + k : points + first_points + k - of_second;
  };
  for (const auto& second : second_.front().stiffness(position.bottomRows(of_second))) {
    entries.emplace_back(place(second.row()), place(second.col()), second.value());
  }
}

std::vector<Eigen::Triplet<double>> BondForces::damping() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * table_->end.size());
  for_each_bond([&](std::int32_t i, std::int32_t j, double) {
    entries.emplace_back(i, i, law_.eta);
    entries.emplace_back(j, j, law_.eta);
    entries.emplace_back(i, j, -law_.eta);
    entries.emplace_back(j, i, -law_.eta);
  });
  if (!has_two_laws()) return entries;
  const auto first_points = static_cast<int>(table_->points);
  for (const auto& entry : second_.front().damping()) {
    entries.emplace_back(first_points + entry.row(), first_points + entry.col(), entry.value());
  }
  return entries;
}

std::string BondForces::name() const {
  if (has_two_laws()) {
    BondForces first = *this;
    first.second_.clear();
    return first.name() + ", of the wall: " + second_.front().name();
  }
  if (law_.k_b != 0.0) return damped() ? "bonds (cubic, damped)" : "bonds (cubic)";
  return damped() ? "bonds (damped)" : "bonds";
}

}  // namespace impact
