#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lattice/input_error.hpp"

/// Expects `statement` to throw an InputError of one line that contains `part`.
#define EXPECT_INPUT_ERROR(statement, part)                                             \
  try {                                                                                 \
    statement;                                                                          \
    ADD_FAILURE() << #statement " did not throw";                                       \
  } catch (const impact::InputError& error) {                                           \
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what(); \
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what(); \
  }
