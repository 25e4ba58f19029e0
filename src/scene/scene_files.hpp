#pragma once

#include <filesystem>
#include <string>

namespace impact {

/// Where the package keeps its scene files: beside the program that runs, in the devel space as in
/// an installed tree (PREFIX/lib/lattice_impact and PREFIX/share/lattice_impact).
std::filesystem::path scene_folder();

/// The file of a scene: `scene` itself, or NAME.yaml of `folder` where it is the bare name of none.
/// @throw InputError for a bare name that is neither; it says which scenes there are.
std::filesystem::path scene_path(const std::string& scene,
                                 const std::filesystem::path& folder = scene_folder());

}  // namespace impact
