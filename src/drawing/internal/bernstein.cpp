#include "drawing/internal/bernstein.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::drawing {
namespace {

/// binomial(n, k) for all n below kMostCoefficients, row by row.
const std::vector<std::vector<double>>& binomials() {
  static const std::vector<std::vector<double>> rows = [] {
    std::vector<std::vector<double>> made(kMostCoefficients);
    for (std::size_t n = 0; n < made.size(); ++n) {
      made[n].assign(n + 1, 1.0);
      for (std::size_t k = 1; k < n; ++k) made[n][k] = made[n - 1][k - 1] + made[n - 1][k];
    }
    return made;
  }();
  return rows;
}

std::size_t sign_changes(Coefficients of) {
  std::size_t changes = 0;
  double last = 0;
  for (const double coefficient : of) {
    if (coefficient == 0) continue;
    if (last != 0 && (coefficient > 0) != (last > 0)) ++changes;
    last = coefficient;
  }
  return changes;
}

/// De Casteljau: `low` becomes the half up to 1/2, `high` the other.
void halve(Coefficients of, std::span<double> low, std::span<double> high) {
  std::copy(of.begin(), of.end(), high.begin());
  for (std::size_t i = 0; i < of.size(); ++i) {
    low[i] = high[0];
    for (std::size_t k = 0; k + 1 < of.size() - i; ++k) high[k] = 0.5 * (high[k] + high[k + 1]);
  }
}

/// The only place in [0, 1] where the sign changes; the ends have different signs.
double only_change(Coefficients of) {
  double low = 0;
  double high = 1;
  const bool rises = of.back() > 0;
  for (int i = 0; i < 48; ++i) {
    const double middle = 0.5 * (low + high);
    ((value_at(of, middle) > 0) == rises ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

void append_changes(Coefficients of, double from, double to, std::vector<double>& places) {
  constexpr double kNarrow = 1e-12;
  const std::size_t changes = sign_changes(of);
  if (changes == 0) return;
  if (changes == 1 && of.front() != 0 && of.back() != 0) {
    places.push_back(from + (to - from) * only_change(of));
    return;
  }
  const double middle = 0.5 * (from + to);
  if (to - from < kNarrow) {
    places.push_back(middle);
    return;
  }
  std::array<double, kMostCoefficients> store_low;
  std::array<double, kMostCoefficients> store_high;
  const std::span low(store_low.data(), of.size());
  const std::span high(store_high.data(), of.size());
  halve(of, low, high);
  append_changes(low, from, middle, places);
  if (high.front() == 0) places.push_back(middle);
  append_changes(high, middle, to, places);
}

}  // namespace

void multiply(Coefficients a, Coefficients b, std::span<double> product) {
  const auto& choose = binomials();
  const std::vector<double>& of_a = choose[a.size() - 1];
  const std::vector<double>& of_b = choose[b.size() - 1];
  std::fill(product.begin(), product.end(), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] += of_a[i] * a[i] * of_b[k] * b[k];
  }
  const std::vector<double>& of_product = choose[product.size() - 1];
  for (std::size_t i = 0; i < product.size(); ++i) product[i] /= of_product[i];
}

void derive(Coefficients of, std::span<double> slope) {
  const auto degree = static_cast<double>(slope.size());
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = degree * (of[i + 1] - of[i]);
}

double value_at(Coefficients of, double t) {
  const std::vector<double>& choose = binomials()[of.size() - 1];
  double value = 0;
  double power = 1;                              // of t
  for (std::size_t i = 0; i < of.size(); ++i) {  // Horner in t, with (1 - t) as the other factor
    value = value * (1 - t) + choose[i] * power * of[i];
    power *= t;
  }
  return value;
}

void append_sign_changes(Coefficients of, std::vector<double>& places) {
  append_changes(of, 0, 1, places);
}

}  // namespace kerf::drawing
