#include "control/gcode/cycles/maximum_tree.hpp"

#include <algorithm>
#include <limits>

namespace kerf::control {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

}  // namespace

MaximumTree::MaximumTree(const std::vector<double>& values) : size_(values.size()) {
  while (leaves_ < size_) leaves_ *= 2;
  tree_.assign(2 * leaves_, kNone);
  for (std::size_t i = 0; i < size_; ++i) tree_[leaves_ + i] = values[i];
  for (std::size_t i = leaves_ - 1; i > 0; --i) tree_[i] = std::max(tree_[2 * i], tree_[2 * i + 1]);
}

std::size_t MaximumTree::first_above(std::size_t from, double bound) const {
  if (from >= size_) return size_;
  std::size_t node = leaves_ + from;
  while (tree_[node] <= bound) {
    while (node % 2 == 1) node /= 2;  // nothing to the right below the same parent
    if (node == 0) return size_;
    ++node;
  }
  while (node < leaves_) node = 2 * node + (tree_[2 * node] > bound ? 0 : 1);
  return node - leaves_;
}

double MaximumTree::maximum(std::size_t first, std::size_t last) const {
  double most = kNone;
  std::size_t left = leaves_ + first;
  std::size_t right = leaves_ + last;
  for (; left < right; left /= 2, right /= 2) {
    if (left % 2 == 1) most = std::max(most, tree_[left++]);
    if (right % 2 == 1) most = std::max(most, tree_[--right]);
  }
  return most;
}

}  // namespace kerf::control
