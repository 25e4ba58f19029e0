#pragma once

#include <memory>
#include <mutex>

#include "mechanics/force_field.hpp"
#include "mechanics/model_error.hpp"
#include "mechanics/state.hpp"
#include "reduced/modal_dynamics.hpp"
#include "statics/folding.hpp"

namespace impact {

/// Of all points in the frame that turns with the body, along x and then along y: a column each of
/// elastic displacements (R) and their rates (c).
Eigen::MatrixXd elastic_displacements(const BulkModes& modes, const Eigen::MatrixXd& amplitudes);

/// The state of an undeformed body.
ModalState modal_state(const BulkModes& modes, const State& start);

/// What the forces of all points are beyond those of a ModalDynamics, on its way through an impact,
/// and what it leaves out then.
///
/// The impact is run with the linear bulk. At intervals, while the wall pushes, the positions of
/// all points give the true forces of bonds and damping and the centrifugal and Coriolis forces;
/// their part on the modes, less what the linear bulk has, is a force g(t) that is added in a
/// second run, which gives the next g(t), and so on (defect correction), four times at most. So the
/// motion converges to the Galerkin projection of the whole nonlinear lattice. It is done when e
/// changes by less than a tenth of `error`.
///
/// What is left out, relative, of e:
/// - of the iteration, what the geometric series of its latest two changes goes on to, but half of
///   the latest and 0.03 of the one before it at least, since one may be small by chance;
/// - of g(t), which is taken at times of a run with another step, a fiftieth of the first change;
/// - of the space of modes, five times the energy rᵀ K⁺ r/2, over that which is left, of the forces
///   r on all points that it does not hold, at the strongest of some times: as the displacements
///   K⁺ B are in it, what is missing acts on the contact in second order only. The bonds may soften
///   under K⁺ r: the energy is that of the geometric series which the next response begins;
/// - the same of the energy that the wall would give to points not among those in contact.
/// The passes begin where the force is 10⁻⁴ of its greatest, and end where the wall holds 10⁻³
/// `error` of the energy. The last one, in shorter steps, ends with the last instant.
///
/// A point that snaps through a bond is not among the modes: the lattice may fold if a triangle has
/// less than ModelError::kLeastAreaLeft of its area at the strongest of the times.
///
/// Of the spin, the same of its changes and of the impulse at a lever arm of R; of forces and
/// times, the change of the greatest force and the root of the third.
struct ModalCorrection {
  std::shared_ptr<const ForceCourse> forces;
  ModelError left_out;
};

/// Of a body with these triangles that starts so; `error`: wanted, of e, relative.
ModalCorrection modal_correction(const ModalSystem& system, const ForceField& field,
                                 const Triangles& triangles, const State& start,
                                 Compliance& compliance, double error);

/// Made when somebody asks for it, once.
class ModalCorrectionOnDemand {
 public:
  template <class Make>
  const ModalCorrection& of(const Make& make) {
    std::call_once(once_, [&] { correction_ = make(); });
    return correction_;
  }

 private:
  std::once_flag once_;
  ModalCorrection correction_;
};

}  // namespace impact
