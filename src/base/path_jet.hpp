#pragma once

#include "base/axes.hpp"
#include "base/point.hpp"

namespace kerf::base {

/// A point that moves along a path: where it is, and its first three derivatives by the parameter
/// of the path, per unit of that, its square and its cube. Entries as in AxisVector.
template <typename Frame>
struct PathJet {
  Point<Frame> value;
  AxisVector first;
  AxisVector second;
  AxisVector third;

  friend bool operator==(const PathJet&, const PathJet&) = default;
};

using TipJet = PathJet<frame::Tip>;
using JointJet = PathJet<frame::Joints>;

}  // namespace kerf::base
