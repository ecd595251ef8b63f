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

}  // namespace kerf::stock
