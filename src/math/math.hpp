#pragma once

namespace kerf::math {

/// The elementary functions, with the same bits on every processor and with every compiler and C
/// library: those of the C library choose their code by the processor, and round as they like.
/// sqrt, floor, fmod and their kind are exact in every library and stay std::'s.
///
/// What is said of each function is the largest error against the true value, in units of the last
/// digit of the result (0.5 is the best possible); results below 2^-1022 may be off by one of
/// theirs. tests/math holds it against MPFR. Arguments that are not numbers, infinite ones and
/// zeros with a sign behave as ISO C, annex F, has it. None sets errno, allocates or waits.
///
/// How: arguments are brought into a short interval around an entry of a table, computed as sums of
/// two doubles (internal/pair.hpp); what lies between entries is a short series.

/// Of an angle in radians, of any size. 0.55.
[[nodiscard]] double sin(double angle_rad);
[[nodiscard]] double cos(double angle_rad);

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};
/// Both, the same bits as alone.
[[nodiscard]] SineCosine sine_cosine(double angle_rad);
/// 0.53.
[[nodiscard]] double tan(double angle_rad);

/// Radians. 0.51; not a number outside [-1, 1].
[[nodiscard]] double asin(double x);
[[nodiscard]] double acos(double x);
/// Radians. 0.51.
[[nodiscard]] double atan(double x);
[[nodiscard]] double atan2(double y, double x);

/// 0.52.
[[nodiscard]] double exp(double x);
/// Natural; 0.51. Not a number below 0, minus infinity of 0.
[[nodiscard]] double log(double x);
[[nodiscard]] double log2(double x);
[[nodiscard]] double log10(double x);
/// x to the power of y, 0.52; exact where the result is a double. Not a number where x < 0 and y is
/// no integer.
[[nodiscard]] double pow(double x, double y);

/// sqrt(x^2 + y^2), without overflow on the way; 0.51.
[[nodiscard]] double hypot(double x, double y);
[[nodiscard]] double hypot(double x, double y, double z);
/// Cube root; 0.51.
[[nodiscard]] double cbrt(double x);

}  // namespace kerf::math
