#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace impact {

/// What a reader should know of a run and its answer; doc/results.md says when each is set.
enum class Flag {
  kStartsInWall,
  kCutOff,
  kStepReduced,
  kEnergyError,
  kFolded,
  kBesideWall,
  kHops,
  kChargeIgnored,
  kFloppy,
  kSeveralRests,
  kNotSeparated,
  kNotAtRest,
  kFailed,
  kInterrupted,
  kIncomplete,
  kDamaged,
  kDisagrees
};

struct FlagText {
  Flag flag;
  const char* name;  ///< in results and messages
  const char* meaning;
  bool is_sound;  ///< see is_sound()
};

/// In the order of Flag.
inline constexpr std::array<FlagText, 17> kFlags{{
    {Flag::kStartsInWall, "starts_in_wall", "the wall reaches the disk at the start", false},
    {Flag::kCutOff, "cut_off", "the wall still repels at wall.threshold, where it ends", false},
    {Flag::kStepReduced, "step_reduced", "the wall grew too stiff for the step, which was halved",
     true},
    {Flag::kEnergyError, "energy_error", "the energy drifts by more than numerics.error", false},
    {Flag::kFolded, "folded", "a triangle of the lattice turned over", true},
    {Flag::kBesideWall, "beside_wall", "part of the disk lay beside the wall, which is too narrow",
     false},
    {Flag::kHops, "hops", "energy changes as contacts pass from bond to bond", true},
    {Flag::kChargeIgnored, "charge_ignored", "the file has charges, which are ignored", true},
    {Flag::kFloppy, "floppy", "the lattice can change its shape without a change of a bond", true},
    {Flag::kSeveralRests, "several_rests", "the disk rests in other orientations too", true},
    {Flag::kNotSeparated, "not_separated", "given up: the disk has not left the wall", false},
    {Flag::kNotAtRest, "not_at_rest", "given up: the disk has not come to rest", false},
    {Flag::kFailed, "failed", "the run broke off", false},
    {Flag::kInterrupted, "interrupted", "the run was interrupted", false},
    {Flag::kIncomplete, "incomplete", "messages are missing", false},
    {Flag::kDamaged, "damaged", "messages are damaged", false},
    {Flag::kDisagrees, "disagrees", "the states give another e than the simulation", false},
}};

constexpr const char* name_of(Flag flag) { return kFlags[static_cast<std::size_t>(flag)].name; }

/// Of the flag of this name; nullptr where there is none.
inline const FlagText* text_of_flag(const std::string& name) {
  const auto* const found = std::find_if(kFlags.begin(), kFlags.end(),
                                         [&](const FlagText& text) { return name == text.name; });
  return found == kFlags.end() ? nullptr : found;
}

/// Whether a list of names has that of the flag.
template <class Flags>
bool has_flag(const Flags& flags, Flag flag) {
  return std::find(flags.begin(), flags.end(), name_of(flag)) != flags.end();
}

/// Whether the answer of a run with flags of these names belongs into a mean or a fit: the model's
/// own answer, be the lattice folded, the contact hopping from bond to bond or the place of rest
/// one of several, and not one of too coarse a step, a start inside the wall's reach, a wall cut
/// off or too narrow, or a run given up.
template <class Flags>
bool is_sound(const Flags& flags) {
  return std::all_of(flags.begin(), flags.end(), [](const std::string& name) {
    const FlagText* const text = text_of_flag(name);
    return text != nullptr && text->is_sound;
  });
}

}  // namespace impact
