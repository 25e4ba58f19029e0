#pragma once

#include <Eigen/SparseCore>
#include <boost/align/aligned_allocator.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "kernels/in_parts.hpp"
#include "kernels/kernels.hpp"
#include "kernels/panel_cholesky.hpp"
#include "lattice/lattice.hpp"

namespace impact {

/// Constants of every bond.
struct BondLaw {
  double k_a = 1.0;     ///< linear stiffness, M c²/R²
  double k_b = 1.0e-3;  ///< cubic stiffness, M c²/R⁴
  double eta = 0.0;     ///< viscosity, M c/R (η* M/N)
};

/// The springs of the lattice, eq. (1) with the dissipative sign of eqs. (3) and (6). Bond ij with
/// elongation x = |r_i − r_j| − l_ij and unit vector n from j to i exerts on i
///   f_i = −(k_a x + k_b x³) n − η (v_i − v_j),   f_j = −f_i.
/// The damping resists the whole relative velocity, not its part along the bond: linear momentum
/// is conserved, but angular momentum is not when η > 0 (a spinning disk slows down).
/// The loop over the bonds is instantiated for (k_b ≠ 0, η ≠ 0), so that a law without a cubic
/// term or without damping does not evaluate it, and for several instruction sets, see Kernels.
/// Every bond is evaluated at each of its ends, which needs no scattered writing.
///
/// Bodies of one law are one lattice; for two laws see of_two_laws().
class BondForces {
 public:
  BondForces(const Lattice& lattice, const BondLaw& law,
             const Kernels& kernels = impact::kernels());

  /// Those of a first body and of others with another law; the rows of the second come after those
  /// of the first.
  static BondForces of_two_laws(BondForces first, BondForces second);

  /// Overwrites `force` (M c²/R) with the force on each point. Returns the power that the damping
  /// dissipates, η Σ |v_i − v_j|² (M c³/R). Velocities are not read when the law has no damping.
  double evaluate(const PointArray& position, const PointArray& velocity, PointArray& force) {
    return evaluate_all(&position, &velocity, force);
  }

  /// The same without damping.
  void evaluate_elastic(const PointArray& position, PointArray& force) {
    evaluate_all(&position, nullptr, force);
  }

  /// The same of bodies of one law, in passing: place(rows) is called for rows of points before
  /// their positions, which it may change, are read and their forces are overwritten, and
  /// use(part, rows) once their forces are there. See in_passing().
  template <class Place, class Use>
  void evaluate_elastic(const PointArray& position, PointArray& force, const Place& place,
                        const Use& use) {
    make_room(position_pairs_);
    const BondEvaluation evaluation = evaluation_of(force);
    in_passing(
        parts_of(table_->points), table_->needed,
        [&](Eigen::Index part) {
          const PointRows rows = rows_of_part(part, table_->points);
          place(rows);
          pair_up(position, rows, position_pairs_);
        },
        [&](Eigen::Index part) {
          const PointRows rows = rows_of_part(part, table_->points);
          kernel(&position, nullptr)(evaluation, rows.first / kSlice,
                                     whole_slices(rows.first + rows.size));
          use(part, rows);
        });
  }

  /// The forces of the damping alone, overwritten, and the power that it dissipates.
  double evaluate_damping(const PointArray& velocity, PointArray& force) {
    return evaluate_all(nullptr, &velocity, force);
  }

  /// The entries of the Laplacian matrix of the damping, η on the diagonal for each bond of a point
  /// and −η between its ends (M c/R), those of one place to be added up.
  std::vector<Eigen::Triplet<double>> damping() const;

  /// Of a matrix with the elements of damping() and a diagonal. Found when somebody asks for it,
  /// for all copies.
  const EliminationOrder& elimination_order() const;

  Eigen::Index points() const {
    return second_.empty() ? table_->points : table_->points + second_.front().points();
  }
  /// See of_two_laws().
  bool has_two_laws() const { return !second_.empty(); }

  /// Σ k_a x²/2 + k_b x⁴/4, in M c².
  double potential_energy(const PointArray& position) const {
    return potential_energy(position, 0, position.rows());
  }
  /// Of the bonds of the body that lies in the rows first … end − 1.
  double potential_energy(const PointArray& position, Eigen::Index first, Eigen::Index end) const;

  /// The entries of the tangent stiffness matrix −∂f/∂r (M c²/R²), those of one place to be added
  /// up; row and column i stand for x of point i, N + i for its y.
  std::vector<Eigen::Triplet<double>> stiffness(const PointArray& position) const;
  /// The same in place of the entries given, whose memory is used again.
  void find_stiffness(const PointArray& position,
                      std::vector<Eigen::Triplet<double>>& entries) const;

  bool damped() const { return law_.eta != 0.0 || (has_two_laws() && second_.front().damped()); }
  /// Of the first body.
  const BondLaw& law() const { return law_; }

  /// The same bonds, of one law, with other constants.
  BondForces with(const BondLaw& law) const;

  /// "bonds", with what the law has besides the linear spring: "bonds (cubic, damped)".
  std::string name() const;

 private:
  template <class Number>
  using Aligned =
      std::vector<Number, boost::alignment::aligned_allocator<Number, kSlice * sizeof(double)>>;

  /// See BondRows. Shared by all copies, since it never changes.
  struct Table {
    Eigen::Index points = 0;
    std::vector<std::int32_t> begin;
    Aligned<std::int32_t> end;
    Aligned<double> natural_length;
    PartsNeeded needed;
    Eigen::Index slices() const { return static_cast<Eigen::Index>(begin.size()) - 1; }
  };
  struct OrderOnDemand {
    std::once_flag once;
    EliminationOrder order;
  };
  static std::shared_ptr<const Table> table_of(const Lattice& lattice);
  static PartsNeeded parts_needed(const Table& table);

  /// Calls use(i, j, natural length) for each bond of each point i in these rows, of the first body
  /// or those of its law.
  template <class Use>
  void for_each_end(Eigen::Index first, Eigen::Index end, const Use& use) const;
  /// The same for each bond once, i < j.
  template <class Use>
  void for_each_bond(const Use& use) const;
  Elongations elongations_at(const PointArray& position, Eigen::Index first,
                             Eigen::Index end) const;
  double evaluate_all(const PointArray* position, const PointArray* velocity, PointArray& force);
  double evaluate_first(const PointArray* position, const PointArray* velocity, PointArray& force);
  double evaluate_second(const PointArray* position, const PointArray* velocity, PointArray& force);
  BondKernel kernel(const PointArray* position, const PointArray* velocity) const;
  BondEvaluation evaluation_of(PointArray& force) const;
  bool first_is_damped() const { return law_.eta != 0.0; }
  void make_room(Aligned<double>& pairs) const;
  void pair_up(const PointArray& points, const PointRows& rows, Aligned<double>& pairs) const;
  /// All of them, with room for them where there is none yet.
  void pair_up(const PointArray& points, Aligned<double>& pairs) const;

  BondLaw law_;
  const Kernels* kernels_;
  std::shared_ptr<const Table> table_;
  std::shared_ptr<OrderOnDemand> order_ = std::make_shared<OrderOnDemand>();
  Aligned<double> position_pairs_;  ///< of the last evaluation, if there was one
  Aligned<double> velocity_pairs_;  ///< the same, of a law with damping
  std::vector<double> part_sums_;   ///< what a kernel returns, of each part of the points
  std::vector<BondForces> second_;  ///< of the other bodies, by themselves; empty: of one law
  struct {
    PointArray position, velocity, force;
  } of_second_;  ///< its rows, between two evaluations of no meaning
};

}  // namespace impact
