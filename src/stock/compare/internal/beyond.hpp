#pragma once

#include <algorithm>

namespace kerf::stock::compare {

/// How far `at` lies outside of [low, high]; 0 within.
inline double beyond(double at, double low, double high) {
  return std::max({low - at, at - high, 0.0});
}

}  // namespace kerf::stock::compare
