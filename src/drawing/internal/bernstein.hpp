#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kerf::drawing {

/// Polynomials on [0, 1] by their Bernstein coefficients, degree + 1 of them. Such a polynomial
/// lies between its least and its largest coefficient, and has no more roots inside than its
/// coefficients change their sign: what is found of it is proven, not sampled.
using Coefficients = std::span<const double>;
/// The degree of kappa' of a rational curve of degree 10 (bezier.hpp) is 108.
inline constexpr std::size_t kMostCoefficients = 128;

/// Into `product`, which has the size of both together less one.
void multiply(Coefficients a, Coefficients b, std::span<double> product);
/// Into `slope`, one less.
void derive(Coefficients of, std::span<double> slope);
[[nodiscard]] double value_at(Coefficients of, double t);

/// Appends the places in (0, 1) where the polynomial changes its sign, ascending, to 1e-12.
void append_sign_changes(Coefficients of, std::vector<double>& places);

}  // namespace kerf::drawing
