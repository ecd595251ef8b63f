#pragma once

#include <cstddef>
#include <vector>

namespace kerf::control {

/// A row of numbers that is asked where it first exceeds a bound: a binary tree of maxima, O(n) to
/// make, O(log n) to ask. Value type.
class MaximumTree {
 public:
  explicit MaximumTree(const std::vector<double>& values);

  /// The first index >= `from` whose value is above `bound`; the row's size when there is none.
  [[nodiscard]] std::size_t first_above(std::size_t from, double bound) const;
  /// The largest of the values [first, last); minus infinity of none. Precondition: last <= size.
  [[nodiscard]] double maximum(std::size_t first, std::size_t last) const;

 private:
  std::size_t size_;
  std::size_t leaves_ = 1;    // a power of two
  std::vector<double> tree_;  // node i has 2i and 2i + 1 below it; the values begin at leaves_
};

}  // namespace kerf::control
