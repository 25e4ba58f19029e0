#pragma once

namespace impact {

/// How far what a motion leaves out of the bodies may change what is measured of an impact; 0 where
/// all points move by themselves.
struct ModelError {
  double restitution = 0.0;  ///< of e, relative
  double spin = 0.0;         ///< of the spin after, c/R
  double others = 0.0;       ///< of forces and times, relative
};

}  // namespace impact
