#include "mechanics/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace impact {
namespace {

using Vector = Eigen::VectorXd;

constexpr int kMostLanczosSteps = 300;
constexpr int kLookInterval = 5;     // iterations
constexpr double kTolerance = 1e-5;  // growth of the Ritz value between two looks
constexpr double kMargin = 2e-3;
constexpr double kBreakdown = 1e-13;

Vector random_unit_vector(Eigen::Index size) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Vector vector(size);
  for (Eigen::Index i = 0; i < size; ++i) vector(i) = normal(random);
  return vector.normalized();
}

double largest_ritz_value(const std::vector<double>& diagonal,
                          const std::vector<double>& off_diagonal) {
  const auto size = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Vector>(diagonal.data(), size),
                                Eigen::Map<const Vector>(off_diagonal.data(), size - 1),
                                Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(size - 1);
}

/// Upper bound of the largest eigenvalue of a symmetric positive semi-definite operator
/// `multiply(in, out)`, from this vector on.
template <class Multiply>
double largest_eigenvalue(Vector current, const Multiply& multiply) {
  Vector previous = Vector::Zero(current.size());
  Vector next(current.size());
  std::vector<double> diagonal;
  std::vector<double> off_diagonal;
  double largest = 0.0;
  for (int k = 1; k <= kMostLanczosSteps; ++k) {
    multiply(current, next);
    if (k > 1) next -= off_diagonal.back() * previous;
    diagonal.push_back(next.dot(current));
    next -= diagonal.back() * current;
    const double beta = next.norm();

    const bool exhausted = beta <= kBreakdown * std::abs(diagonal.front());
    if (exhausted || k % kLookInterval == 0) {
      const double before = largest;
      largest = largest_ritz_value(diagonal, off_diagonal);
      if (exhausted || largest - before <= kTolerance * largest) break;
    }
    off_diagonal.push_back(beta);
    previous.swap(current);
    current = next / beta;
  }
  return largest * (1.0 + kMargin);
}

struct Direction {
  double x;
  double y;
};

/// Of every bond.
std::vector<Direction> directions(const Lattice& lattice) {
  std::vector<Direction> all;
  all.reserve(lattice.bonds.size());
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Bond& bond = lattice.bonds[k];
    const auto way = (lattice.points.row(bond.first) - lattice.points.row(bond.second)).eval();
    all.push_back({way(0) / lattice.natural_lengths[k], way(1) / lattice.natural_lengths[k]});
  }
  return all;
}

/// Adds Σ n nᵀ in, x and y of each point side by side.
void add_stiffness(const Lattice& lattice, const std::vector<Direction>& direction,
                   const Vector& in, Vector& out) {
  const std::vector<Bond>& bonds = lattice.bonds;
  for (std::size_t k = 0; k < bonds.size();) {
    const Eigen::Index first = 2 * Eigen::Index{bonds[k].first};
    const double x = in(first);
    const double y = in(first + 1);
    double sum_x = out(first);
    double sum_y = out(first + 1);
    for (; k < bonds.size() && 2 * Eigen::Index{bonds[k].first} == first; ++k) {
      const Eigen::Index second = 2 * Eigen::Index{bonds[k].second};
      const Direction n = direction[k];
      const double elongation = n.x * (x - in(second)) + n.y * (y - in(second + 1));
      sum_x += elongation * n.x;
      sum_y += elongation * n.y;
      out(second) -= elongation * n.x;
      out(second + 1) -= elongation * n.y;
    }
    out(first) = sum_x;
    out(first + 1) = sum_y;
  }
}

/// What holds a point: `along` times its displacement along the normal, and `across` times the
/// whole of it.
struct Spring {
  std::int32_t point;
  Direction normal;
  double along;
  double across;
};

void add_springs(const std::vector<Spring>& springs, const Vector& in, Vector& out) {
  for (const Spring& spring : springs) {
    const Eigen::Index i = 2 * Eigen::Index{spring.point};
    const Direction n = spring.normal;
    const double tension = spring.along * (n.x * in(i) + n.y * in(i + 1));
    out(i) += tension * n.x + spring.across * in(i);
    out(i + 1) += tension * n.y + spring.across * in(i + 1);
  }
}

/// Of this stiffness along the normal of the outline, from where the bonds of a point lie, and of
/// kShareAcross of it along the outline. Of all stiffness in each direction where the bonds do not
/// tell.
std::vector<Spring> springs_on(const std::vector<std::int32_t>& points, double stiffness,
                               const Lattice& lattice, const std::vector<Direction>& direction) {
  constexpr double kShareAcross = 0.3;
  constexpr double kLeastOutward = 1.0;
  PointArray outward = PointArray::Zero(lattice.points.rows(), 2);
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Eigen::Array<double, 1, 2> n(direction[k].x, direction[k].y);
    outward.row(lattice.bonds[k].first) += n;
    outward.row(lattice.bonds[k].second) -= n;
  }
  std::vector<Spring> springs;
  springs.reserve(points.size());
  for (const std::int32_t point : points) {
    const double size = outward.row(point).matrix().norm();
    if (size < kLeastOutward) {
      springs.push_back({point, {0.0, 0.0}, 0.0, stiffness});
      continue;
    }
    const double across = kShareAcross * stiffness;
    springs.push_back(
        {point, {outward(point, 0) / size, outward(point, 1) / size}, stiffness - across, across});
  }
  return springs;
}

/// Of a lattice with k_a = 1.
double largest_stiffness(const Lattice& lattice, const std::vector<Direction>& direction,
                         const std::vector<Spring>& springs, const Vector& start) {
  return largest_eigenvalue(start, [&](const Vector& in, Vector& out) {
    out.setZero();
    add_springs(springs, in, out);
    add_stiffness(lattice, direction, in, out);
  });
}

double largest_laplacian_eigenvalue(const Lattice& lattice) {
  const Vector start = random_unit_vector(lattice.points.rows());
  return largest_eigenvalue(start, [&](const Vector& in, Vector& out) {
    out.setZero();
    for (const Bond& bond : lattice.bonds) {
      const double difference = in(bond.first) - in(bond.second);
      out(bond.first) += difference;
      out(bond.second) -= difference;
    }
  });
}

}  // namespace

double Spectrum::with_contacts(double rate, double inner_share) const {
  const double known = kStiffening * omega_squared;
  const double highest = stiffened > 0.0 ? stiffened : omega_squared + known;
  const double of_outer = rate < known ? omega_squared + (highest - omega_squared) * rate / known
                                       : highest + (rate - known);
  return std::min(of_outer + inner_share * rate, omega_squared + rate);
}

Spectrum lattice_spectrum(const Lattice& lattice, const BondLaw& law, double point_mass,
                          const std::vector<std::int32_t>& outer) {
  const std::vector<Direction> direction = directions(lattice);
  const double unit = law.k_a / point_mass;
  const Vector start = random_unit_vector(2 * lattice.points.rows());
  const double stiffness = largest_stiffness(lattice, direction, {}, start);
  Spectrum spectrum;
  spectrum.omega_squared = unit * stiffness;
  if (!outer.empty()) {
    const double stiffening = Spectrum::kStiffening * stiffness;
    spectrum.stiffened =
        unit * largest_stiffness(lattice, direction,
                                 springs_on(outer, stiffening, lattice, direction), start);
  }
  if (law.eta != 0.0) {
    spectrum.gamma = law.eta * largest_laplacian_eigenvalue(lattice) / point_mass;
  }
  return spectrum;
}

}  // namespace impact
