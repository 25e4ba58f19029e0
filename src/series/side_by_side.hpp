#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "run/bodies.hpp"
#include "scene/scene.hpp"
#include "series/convergence_study.hpp"
#include "series/series_file.hpp"

namespace impact {

/// What became of scenes.
struct SeriesOutcome {
  /// In the order of the scenes. A run that cannot go on has its reason in its flags.
  std::vector<Result> results{};
  /// The InputError of the first scene that cannot be composed; it and those after it have no
  /// result.
  std::exception_ptr error{};
  bool in_lanes = false;  ///< whether any were
};

/// Whether it is worthwhile to ask LaneField::knows() of the scene: an impact by a method of fixed
/// step, of bodies of one material and without dashpots; or a static solution.
bool may_be_in_lanes(const Scene& scene);

/// The bodies of scenes of the same bodies, with all of the spectrum that one of them needs.
std::shared_ptr<const Bodies> make_common_bodies(const std::vector<Scene>& scenes);

/// Simulates scenes of these bodies, all or none of them static, that may_be_in_lanes(), side by
/// side; where one run is done, another takes its lane, and the runs that an answer takes go on
/// at the same time. As soon as too few of one kind are left to gain from it, they go on by
/// themselves, as do scenes that lanes do not know and those of very many points. Each result is
/// that of a ConvergenceStudy by itself, to the last bit, except for wall_time: the time of a step
/// is shared out among those that make it. `done` is told of every scene that is. @return nothing
/// when told to stop, which is asked often.
std::optional<SeriesOutcome> simulate_side_by_side(const std::vector<Scene>& scenes,
                                                   std::shared_ptr<const Bodies> bodies,
                                                   const std::function<bool()>& stop,
                                                   const std::function<void()>& done);

}  // namespace impact
