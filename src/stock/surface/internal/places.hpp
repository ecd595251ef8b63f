// Places on a lattice, in steps of a cell, and which of its lines are looked at.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "stock/surface/samples.hpp"

namespace kerf::stock::surface {

/// A face that lies so near to points of the lattice (of a cell) is told alike by all lines.
inline constexpr double kSlack = 2e-3;

inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

inline Place moved(Place at, int axis, int by) {
  at[index(axis)] += by;
  return at;
}

/// Numbers of the lines that are looked at: every `stride`-th, from the middle of the first group;
/// -1 before and behind them.
inline std::vector<int> chosen(int count, int stride) {
  std::vector<int> numbers{-1};
  const int first = std::min(stride / 2, (count - 1) / 2);
  for (int i = first; i < count; i += stride) numbers.push_back(i);
  numbers.push_back(-1);
  return numbers;
}

}  // namespace kerf::stock::surface
