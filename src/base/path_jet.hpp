#pragma once

#include "base/axes.hpp"

namespace kerf::base {

/// A point of a path and its first three derivatives by the path's parameter: per mm, per mm² and
/// per mm³ when the parameter is a length.
struct PathJet {
  AxisVector value;
  AxisVector first;
  AxisVector second;
  AxisVector third;
};

}  // namespace kerf::base
