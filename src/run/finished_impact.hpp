#pragma once

#include <cstdint>

#include "measure/impact_analysis.hpp"
#include "mechanics/model_error.hpp"
#include "run/run.hpp"

namespace impact {

/// What error control needs to know of an impact that was run to its end.
struct FinishedImpact {
  Restitution measured;
  double step = 0.0;  ///< R/c, at the end: the shortest
  std::uint64_t steps = 0;
  double time = 0.0;        ///< R/c
  double tail_error = 0.0;  ///< Run::tail_error()
  /// Relative: how far it could change e that contacts pass from bond to bond, by hops of energy
  /// and by turns of the force.
  double error_by_hops = 0.0;
  ModelError model_error{};  ///< of the bodies that were moved
  bool step_reduced = false;
  double stiffest_contact = 0.0;  ///< System::stiffest_contact()
  double lost_of_spin = 0.0;      ///< by damping, relative, from the end of the contact on
  bool not_separated = false;
  bool folded = false;
  bool cut_off = false;
};

/// Of this run, at the end of which this was measured.
FinishedImpact finished_impact(const Run& run, const Restitution& measured);

/// What is measured when the disk has left for good too: the wall's energy U that is left at the
/// end of a run still adds U/v′ to the velocity v′ of the disk (M = 1, U ≪ v′²), of which it is μ
/// times as much where another disk flies away too, and U to the energy of all.
Restitution after_the_tail(const Run& run, Restitution measured);

}  // namespace impact
