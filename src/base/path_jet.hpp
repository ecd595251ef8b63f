#pragma once

#include "base/axes.hpp"

namespace kerf::base {

/// A point that moves along a path: where it is, and its first three derivatives by the parameter
/// of the path, per unit of that, its square and its cube. Entries as in AxisVector.
struct PathJet {
  AxisVector value;
  AxisVector first;
  AxisVector second;
  AxisVector third;

  friend bool operator==(const PathJet&, const PathJet&) = default;
};

}  // namespace kerf::base
