#pragma once

#include <array>
#include <cstddef>

namespace impact {

enum class IntegratorKind {
  kAuto,
  kVerlet,
  kTakahashiImada,
  kBlanesMoan,
  kImplicitDamping,
  kExtrapolatedDamping,
  kImex,     ///< bonds implicit as well
  kBdf,      ///< SUNDIALS CVODE, for stiff damping
  kRk8pd,    ///< GSL, the independent reference
  kReduced,  ///< rigid motion and static compliance, for slow impacts
  kModal,    ///< rigid motion and modes, for slow impacts with damping
  kNewton    ///< no motion: a static solution
};

/// How a method goes on.
enum class Stepping {
  kOpen,      ///< `auto`: as the method that it chooses
  kFixed,     ///< in steps that are given
  kAdaptive,  ///< in steps of its own, from a tolerance
  kReduced,   ///< in steps that are given, of less than all points
  kStatic     ///< to a state at rest, without motion
};

/// For which forces `auto` may choose a method: kFlight, those without damping on a potential wall,
/// and none at the start; kDampedWall, those with damping on a potential wall; kSlow, in a slow
/// impact before all others, see may_be_reduced(); kSlowDamped, in a slow impact, see
/// may_be_modal().
enum class AutoChoice {
  kNever,
  kFlight,
  kUndamped,
  kDamped,
  kDampedWall,
  kAlways,
  kSlow,
  kSlowDamped
};

/// What the package knows of a method, besides how to make it (make_integrator()).
struct IntegratorTraits {
  IntegratorKind kind;
  const char* name;  ///< in scenes, messages and results
  Stepping stepping;
  int order;                ///< of a method whose step is given; else 0
  bool stiff;               ///< solves for velocities, so that damping does not limit its steps
  bool implicit_bonds;      ///< solves for them, so that contacts alone limit its steps
  bool holds_with_damping;  ///< where forces depend on velocities
  bool holds_with_passing;  ///< where contacts pass from bond to bond
  bool in_lanes;            ///< lanes take it; of `auto`: all that it may choose but slow impacts
  AutoChoice choice;
  /// Time of a step without damping, in steps of undamped velocity Verlet, as
  /// test/bench/bench_runs.cpp measures it at N = 1099. Of an adaptive method: of a step of its
  /// own, or of a report if it is stiff, see forecast().
  double cost;
  double damped_cost;  ///< the same with damping
  double factor_cost;  ///< of what a run solves with, once, in the same steps
};

/// A row for each method, in the order of IntegratorKind, which is that of lists for users.
// clang-format off
inline constexpr std::array<IntegratorTraits, 12> kIntegrators{{
    // kind, name, stepping, order,
    //     stiff, implicit bonds, holds with damping, with passing contacts, in lanes,
    //     auto may choose it, cost, damped cost, factor cost
    {IntegratorKind::kAuto, "auto", Stepping::kOpen, 0,
         false, false, true, true, true, AutoChoice::kNever, 0.0, 0.0, 0.0},
    {IntegratorKind::kVerlet, "verlet", Stepping::kFixed, 2,
         false, false, true, true, true, AutoChoice::kAlways, 1.0, 1.5, 0.0},
    {IntegratorKind::kTakahashiImada, "takahashi_imada", Stepping::kFixed, 4,
         false, false, false, false, true, AutoChoice::kFlight, 1.9, 1.9, 0.0},
    {IntegratorKind::kBlanesMoan, "blanes_moan", Stepping::kFixed, 6,
         false, false, false, true, true, AutoChoice::kUndamped, 10.5, 10.5, 0.0},
    {IntegratorKind::kImplicitDamping, "implicit_damping", Stepping::kFixed, 2,
         true, false, true, true, true, AutoChoice::kDamped, 3.9, 3.9, 260.0},
    {IntegratorKind::kExtrapolatedDamping, "extrapolated_damping", Stepping::kFixed, 6,
         true, false, true, true, true, AutoChoice::kDamped, 31.0, 31.0, 780.0},
    {IntegratorKind::kImex, "imex", Stepping::kFixed, 2,
         true, true, true, false, false, AutoChoice::kDampedWall, 4.0, 4.2, 260.0},
    {IntegratorKind::kBdf, "bdf", Stepping::kAdaptive, 0,
         true, false, true, true, false, AutoChoice::kNever, 2.0, 2.0, 0.0},
    {IntegratorKind::kRk8pd, "rk8pd", Stepping::kAdaptive, 0,
         false, false, true, true, false, AutoChoice::kNever, 14.0, 14.0, 0.0},
    {IntegratorKind::kReduced, "reduced", Stepping::kReduced, 2,
         false, false, false, false, false, AutoChoice::kSlow, 0.5, 0.5, 0.0},
    {IntegratorKind::kModal, "modal", Stepping::kReduced, 2,
         true, true, true, false, false, AutoChoice::kSlowDamped, 0.45, 0.45, 1100.0},
    {IntegratorKind::kNewton, "newton", Stepping::kStatic, 0,
         false, false, true, true, true, AutoChoice::kNever, 0.0, 0.0, 0.0},
}};
// clang-format on

constexpr const IntegratorTraits& traits_of(IntegratorKind kind) {
  return kIntegrators[static_cast<std::size_t>(kind)];
}

/// Whether the integrator chooses its steps by itself, from a tolerance.
constexpr bool is_adaptive(IntegratorKind kind) {
  return traits_of(kind).stepping == Stepping::kAdaptive;
}

/// Whether each step of a method of fixed step solves for the velocities of a damped lattice.
constexpr bool solves_for_damping(IntegratorKind kind) {
  return traits_of(kind).stepping == Stepping::kFixed && traits_of(kind).stiff;
}

/// Whether it solves for what the bonds do, too.
constexpr bool solves_for_bonds(IntegratorKind kind) { return traits_of(kind).implicit_bonds; }

/// Whether it follows less than all points: as a rigid body, or in modes.
constexpr bool moves_less_than_all(IntegratorKind kind) {
  return traits_of(kind).stepping == Stepping::kReduced;
}

/// Order of a method whose step is given.
constexpr int order_of(IntegratorKind kind) { return traits_of(kind).order; }

/// What the choice of a method depends on.
struct Circumstances {
  bool damped;   ///< forces depend on velocities
  bool passing;  ///< contacts pass from bond to bond
  bool flying;   ///< no force acts at the start, see Scene::flies_without_forces()
};

/// Whether `auto` may choose the method.
constexpr bool is_automatic(const IntegratorTraits& method, const Circumstances& scene) {
  switch (method.choice) {
    case AutoChoice::kAlways:
      return true;
    case AutoChoice::kFlight:
      return scene.flying && !scene.damped;
    case AutoChoice::kUndamped:
      return !scene.damped;
    case AutoChoice::kDamped:
      return scene.damped;
    case AutoChoice::kDampedWall:
      return scene.damped && !scene.passing;
    case AutoChoice::kNever:
    case AutoChoice::kSlow:
    case AutoChoice::kSlowDamped:
      break;
  }
  return false;
}

}  // namespace impact
