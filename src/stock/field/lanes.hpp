#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace kerf::stock::field {

/// Four floats that are computed with at once, each as if alone. What compilers make of loops
/// depends on how they see through branches; these they take as they are.
using Lanes = float __attribute__((vector_size(16)));
inline constexpr std::size_t kLanes = 4;

inline Lanes load(const float* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline void store(Lanes v, float* to) { std::memcpy(to, &v, sizeof v); }
inline Lanes all(float value) { return Lanes{value, value, value, value}; }

// Of equal arguments either: the same as the instructions of processors.
constexpr float smaller(float a, float b) { return a < b ? a : b; }
constexpr float larger(float a, float b) { return a > b ? a : b; }
inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }

/// Square root, 0 of what is negative.
inline float root(float squared) { return std::sqrt(larger(0.0F, squared)); }
inline Lanes root(Lanes squared) {
  Lanes v = larger(squared, Lanes{});
#ifdef __SSE2__
  return _mm_sqrt_ps(v);
#else
  for (std::size_t i = 0; i < kLanes; ++i) v[i] = std::sqrt(v[i]);
  return v;
#endif
}

}  // namespace kerf::stock::field
