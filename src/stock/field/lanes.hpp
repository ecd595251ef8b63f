#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#ifdef __AVX2__
#include <immintrin.h>
#define KERF_LANES wide_lanes
#elif defined(__SSE2__)
#include <emmintrin.h>
#define KERF_LANES narrow_lanes
#else
#include <cmath>
#define KERF_LANES narrow_lanes
#endif

namespace kerf::stock::field {

/// Some floats that are computed with at once, each as if alone: as many as fit a register of the
/// processor that a file is compiled for. What compilers make of loops depends on how they see
/// through branches; these they take as they are. Files for different processors have names of
/// their own.
namespace KERF_LANES {

#ifdef __AVX2__
inline constexpr std::size_t kLanes = 8;
#else
inline constexpr std::size_t kLanes = 4;
#endif

using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
/// -1 where a condition holds, otherwise 0; also whole numbers.
using LaneInts = std::int32_t __attribute__((vector_size(kLanes * sizeof(float))));
using FourFloats = float __attribute__((vector_size(16)));
using FourDoubles = double __attribute__((vector_size(32)));

inline Lanes load(const float* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline void store(Lanes v, float* to) { std::memcpy(to, &v, sizeof v); }
inline Lanes all(float value) { return Lanes{} + value; }

// Written as instructions: a compiler that finds them itself takes two or three where one of the
// arguments is a constant. Of equal arguments either.
inline Lanes smaller(Lanes a, Lanes b) {
#ifdef __AVX2__
  return _mm256_min_ps(a, b);
#elif defined(__SSE2__)
  return _mm_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}
inline Lanes larger(Lanes a, Lanes b) {
#ifdef __AVX2__
  return _mm256_max_ps(a, b);
#elif defined(__SSE2__)
  return _mm_max_ps(a, b);
#else
  return a > b ? a : b;
#endif
}

/// a where a condition holds, otherwise b.
inline Lanes pick(LaneInts holds, Lanes a, Lanes b) {
#ifdef __AVX2__
  Lanes mask;
  std::memcpy(&mask, &holds, sizeof mask);
  return _mm256_blendv_ps(b, a, mask);
#else
  return holds ? a : b;
#endif
}

/// Without its sign.
inline Lanes size_of(Lanes v) { return larger(v, -v); }
/// Its square with its sign.
inline Lanes signed_square(Lanes v) { return v * size_of(v); }

/// Square root, 0 of what is negative.
inline Lanes root(Lanes squared) {
  const Lanes v = larger(squared, Lanes{});
#ifdef __AVX2__
  return _mm256_sqrt_ps(v);
#elif defined(__SSE2__)
  return _mm_sqrt_ps(v);
#else
  Lanes of = v;
  for (std::size_t i = 0; i < kLanes; ++i) of[i] = std::sqrt(v[i]);
  return of;
#endif
}

/// Bit i: the condition holds in lane i.
inline unsigned bits(LaneInts holds) {
#ifdef __AVX2__
  __m256 signs;
  std::memcpy(&signs, &holds, sizeof signs);
  return static_cast<unsigned>(_mm256_movemask_ps(signs));
#elif defined(__SSE2__)
  __m128 signs;
  std::memcpy(&signs, &holds, sizeof signs);
  return static_cast<unsigned>(_mm_movemask_ps(signs));
#else
  unsigned of = 0;
  for (std::size_t k = 0; k < kLanes; ++k) of |= holds[k] != 0 ? 1U << k : 0U;
  return of;
#endif
}

/// The four of them that begin with number `first`, as doubles: to four places, and added to sums.
template <int first>
void add_doubles(Lanes v, double* to, FourDoubles& sums) {
  const FourFloats four = __builtin_shufflevector(v, v, first, first + 1, first + 2, first + 3);
#ifdef __AVX2__
  const FourDoubles doubles = _mm256_cvtps_pd(four);
#else
  const FourDoubles doubles = __builtin_convertvector(four, FourDoubles);
#endif
  std::memcpy(to, &doubles, sizeof doubles);
  sums += doubles;
}

inline float highest(Lanes of) {
#ifdef __AVX2__
  of = larger(of, __builtin_shufflevector(of, of, 4, 5, 6, 7, 0, 1, 2, 3));
  of = larger(of, __builtin_shufflevector(of, of, 2, 3, 0, 1, 6, 7, 4, 5));
  of = larger(of, __builtin_shufflevector(of, of, 1, 0, 3, 2, 5, 4, 7, 6));
#else
  of = larger(of, __builtin_shufflevector(of, of, 2, 3, 0, 1));
  of = larger(of, __builtin_shufflevector(of, of, 1, 0, 3, 2));
#endif
  return of[0];
}
inline float lowest(Lanes of) { return -highest(-of); }

/// Four doubles less an origin.
inline FourFloats from_origin(const double* places, double origin) {
  FourDoubles v;
  std::memcpy(&v, places, sizeof v);
  return __builtin_convertvector(v - origin, FourFloats);
}

/// The four columns of a row, for as many rows of a block as there are lanes.
inline Lanes along_rows(FourFloats columns) {
#ifdef __AVX2__
  return __builtin_shufflevector(columns, columns, 0, 1, 2, 3, 0, 1, 2, 3);
#else
  return columns;
#endif
}

/// For each row of a block, from `first` on, its place four times.
template <int first>
Lanes across_rows(FourFloats rows) {
#ifdef __AVX2__
  constexpr int next = first + 1;
  return __builtin_shufflevector(rows, rows, first, first, first, first, next, next, next, next);
#else
  return __builtin_shufflevector(rows, rows, first, first, first, first);
#endif
}

}  // namespace KERF_LANES
}  // namespace kerf::stock::field
