#pragma once

namespace impact {

/// Names of the terms of scenes that have other bodies.
constexpr const char* kElasticWallName = "elastic wall";
constexpr const char* kDiskContactName = "contact of disks";

}  // namespace impact
