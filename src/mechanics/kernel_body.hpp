#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "mechanics/kernels.hpp"

/// The kernels for the instruction set that the including file is compiled for. Vectors are those
/// of the compiler (GCC and clang), as wide as the registers.
namespace impact {
namespace {

#if defined(__AVX512F__)
constexpr int kWidth = 8;
#elif defined(__AVX2__)
constexpr int kWidth = 4;
#else
constexpr int kWidth = 2;
#endif
constexpr int kVectors = kSlice / kWidth;  // of a slice

using Pair = double __attribute__((vector_size(2 * sizeof(double))));
using Vector = double __attribute__((vector_size(kWidth * sizeof(double))));
using UnalignedVector = double
    __attribute__((vector_size(kWidth * sizeof(double)), aligned(sizeof(double)), may_alias));

inline Vector load(const double* from) { return *reinterpret_cast<const UnalignedVector*>(from); }

inline void store(const Vector& vector, double* to) {
  *reinterpret_cast<UnalignedVector*>(to) = vector;
}

inline Vector all_of(double value) { return value - Vector{}; }

/// Coordinates of kWidth points.
struct Coordinates {
  Vector x;
  Vector y;
};

/// Of the points at(0), at(1), …
template <class At>
inline Coordinates split(const At& at) {
#if defined(__AVX512F__)
  const auto four = [&](int k) {
    const auto low = __builtin_shufflevector(at(k), at(k + 2), 0, 1, 2, 3);
    const auto high = __builtin_shufflevector(at(k + 4), at(k + 6), 0, 1, 2, 3);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Vector even = four(0);
  const Vector odd = four(1);
  return {__builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14),
          __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15)};
#elif defined(__AVX2__)
  const Vector even = __builtin_shufflevector(at(0), at(2), 0, 1, 2, 3);
  const Vector odd = __builtin_shufflevector(at(1), at(3), 0, 1, 2, 3);
  return {__builtin_shufflevector(even, odd, 0, 4, 2, 6),
          __builtin_shufflevector(even, odd, 1, 5, 3, 7)};
#else
  const Pair first = at(0);
  const Pair second = at(1);
  return {Vector{first[0], second[0]}, Vector{first[1], second[1]}};
#endif
}

inline const Pair* as_pairs(const double* pairs) { return reinterpret_cast<const Pair*>(pairs); }

inline Coordinates coordinates(const double* pairs, std::int64_t first) {
  const Pair* const own = as_pairs(pairs) + first;
  return split([own](int k) { return own[k]; });
}

inline Coordinates coordinates(const double* pairs, const std::int32_t* points) {
  const Pair* const all = as_pairs(pairs);
  return split([all, points](int k) { return all[points[k]]; });
}

#if defined(__AVX512F__)
/// 1/√a: with e = 1 − a y², which is below 2⁻¹³ for the processor's estimate y, the series
/// y (1 + e/2 + 3e²/8 + 5e³/16) errs by 35e⁴/128 < 10⁻¹⁶.
inline Vector inverse_root(const Vector& a) {
  const Vector y = _mm512_maskz_rsqrt14_pd(0xff, a);  // without the mask GCC 12 warns
  const Vector e = 1.0 - a * y * y;
  return y + y * e * (0.5 + e * (0.375 + e * 0.3125));
}
#elif defined(__AVX2__)
inline Vector inverse_root(const Vector& a) { return 1.0 / Vector(_mm256_sqrt_pd(a)); }
#elif defined(__SSE2__)
inline Vector inverse_root(const Vector& a) { return 1.0 / Vector(_mm_sqrt_pd(a)); }
#else
inline Vector inverse_root(const Vector& a) {
  return 1.0 / Vector{__builtin_sqrt(a[0]), __builtin_sqrt(a[1])};
}
#endif

inline double sum_of(const Vector& vector) {
  double sum = 0.0;
  for (int k = 0; k < kWidth; ++k) sum += vector[k];
  return sum;
}

/// Of a part of a slice, kWidth points.
struct Forces {
  Coordinates force;
  Vector relative_speed_squared;
};

template <bool kCubic, bool kDamped>
inline Forces forces_on(const BondEvaluation& evaluation, std::int64_t slice, int part) {
  const std::int64_t first = slice * kSlice + part * kWidth;
  const Coordinates r = coordinates(evaluation.position_pairs, first);
  Coordinates v{};
  if constexpr (kDamped) v = coordinates(evaluation.velocity_pairs, first);
  Forces sum{};
  for (std::int32_t row = evaluation.rows.begin[slice]; row < evaluation.rows.begin[slice + 1];
       ++row) {
    const std::int64_t place = std::int64_t{row} * kSlice + part * kWidth;
    const std::int32_t* const ends = evaluation.rows.end + place;
    const Coordinates other = coordinates(evaluation.position_pairs, ends);
    const Vector dx = r.x - other.x;
    const Vector dy = r.y - other.y;
    const Vector length_squared = dx * dx + (dy * dy + kLeastLengthSquared);
    const Vector inverse_length = inverse_root(length_squared);
    const Vector elongation =
        length_squared * inverse_length - load(evaluation.rows.natural_length + place);
    Vector stiffness = all_of(evaluation.k_a);
    if constexpr (kCubic) stiffness += evaluation.k_b * elongation * elongation;
    const Vector tension_by_length = stiffness * elongation * inverse_length;
    sum.force.x -= tension_by_length * dx;
    sum.force.y -= tension_by_length * dy;
    if constexpr (kDamped) {
      const Coordinates other_v = coordinates(evaluation.velocity_pairs, ends);
      const Vector dvx = v.x - other_v.x;
      const Vector dvy = v.y - other_v.y;
      sum.relative_speed_squared += dvx * dvx + dvy * dvy;
      sum.force.x -= evaluation.eta * dvx;
      sum.force.y -= evaluation.eta * dvy;
    }
  }
  return sum;
}

template <bool kCubic, bool kDamped>
double bonds(const BondEvaluation& evaluation, std::int64_t first, std::int64_t end) {
  double* const fx = evaluation.force;
  double* const fy = fx + evaluation.points;
  Vector relative_speed_squared{};
  for (std::int64_t slice = first; slice < end; ++slice) {
    for (int part = 0; part < kVectors; ++part) {
      const Forces on = forces_on<kCubic, kDamped>(evaluation, slice, part);
      if constexpr (kDamped) relative_speed_squared += on.relative_speed_squared;
      const std::int64_t point = slice * kSlice + part * kWidth;
      if (point + kWidth <= evaluation.points) {
        store(on.force.x, fx + point);
        store(on.force.y, fy + point);
        continue;
      }
      for (int k = 0; point + k < evaluation.points; ++k) {
        fx[point + k] = on.force.x[k];
        fy[point + k] = on.force.y[k];
      }
    }
  }
  return sum_of(relative_speed_squared);
}

void pair_up(const double* x, const double* y, std::int64_t first, std::int64_t end,
             double* pairs) {
  for (std::int64_t i = first; i < end; ++i) {
    pairs[2 * i] = x[i];
    pairs[2 * i + 1] = y[i];
  }
}

void add_scaled(double factor, const double* x, double* y, std::int64_t size) {
  for (std::int64_t i = 0; i < size; ++i) y[i] += factor * x[i];
}

constexpr Kernels kernels_named(const char* name) {
  return {name,
          {{bonds<false, false>, bonds<false, true>}, {bonds<true, false>, bonds<true, true>}},
          pair_up,
          add_scaled};
}

}  // namespace
}  // namespace impact
