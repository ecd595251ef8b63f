#pragma once

#include <algorithm>
#include <limits>

namespace kerf::stock {

/// From the least to the largest of some numbers; of none low > high. Adding is the same in any
/// order.
struct Stretch {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool is_empty() const { return low > high; }
  [[nodiscard]] double length() const { return is_empty() ? 0 : high - low; }
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const Stretch& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// On the way from one number to another what lies in [low, high], in [0, 1] of the way.
[[nodiscard]] inline Stretch shares(double from, double to, double low, double high) {
  if (from == to || low > high) return {};
  const double a = (low - from) / (to - from);
  const double b = (high - from) / (to - from);
  Stretch part{std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
  return part.is_empty() ? Stretch{} : part;
}

}  // namespace kerf::stock
