#pragma once

#include <stdexcept>

namespace impact {

/// Input that cannot be used. `what()` is one line: which key or file line, what it was, what is
/// allowed. Programs print it and exit with code 2, before anything has run.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace impact
