#pragma once

#include <string>
#include <vector>

#include "series/series_file.hpp"

namespace impact {

/// A table of the main results for people (restitution and contact duration of a collision, strain
/// of a contact), by the scene keys in which the rows differ. If they differ in `seed`, a line
/// holds the mean over the seeds and its standard error, of the runs that have that result, and
/// the number of runs with flags; else a line is a run.
std::string summary(const std::vector<Row>& rows);

}  // namespace impact
