#pragma once

#include <cstdint>

/// What a test program takes from the heap, if count_heap_use() of test/CMakeLists.txt made it so.
/// What shared libraries take within themselves is not counted: the linker gives the counting
/// malloc() to the object files of the program only.
namespace impact {

/// So many allocations were made.
std::uint64_t heap_allocations();

/// Bytes that are in use, and the most that were since reset_heap_peak().
std::int64_t heap_in_use();
std::int64_t heap_peak();
void reset_heap_peak();

/// While something is done.
template <class Action>
std::uint64_t allocations_of(const Action& action) {
  const std::uint64_t before = heap_allocations();
  action();
  return heap_allocations() - before;
}

/// The most bytes in use while something is done, besides those that were before.
template <class Action>
std::int64_t most_bytes_of(const Action& action) {
  const std::int64_t before = heap_in_use();
  reset_heap_peak();
  action();
  return heap_peak() - before;
}

}  // namespace impact
