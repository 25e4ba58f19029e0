#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace impact {

/// How many letters one types wrongly to get from one word to the other: letters left out, added or
/// replaced, and neighbours swapped (the optimal string alignment distance).
std::size_t typing_distance(std::string_view a, std::string_view b);

/// " (did you mean impact.velocity?)" for the one of `known` that is nearest to a word which is
/// none of them; empty where none is near. The part of a key after its dot may stand for it.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace impact
