#pragma once

#include "base/path_jet.hpp"
#include "geometry/jet.hpp"

namespace kerf::kinematics {

/// What one axis of a point does along its path.
template <typename Frame>
geometry::Jet jet_of(const base::PathJet<Frame>& point, base::Axis axis) {
  return {point.value[axis], point.first[axis], point.second[axis], point.third[axis]};
}

template <typename Frame>
void set_jet(base::PathJet<Frame>& point, base::Axis axis, const geometry::Jet& jet) {
  point.value[axis] = jet.value;
  point.first[axis] = jet.first;
  point.second[axis] = jet.second;
  point.third[axis] = jet.third;
}

/// Whether an axis of a point stands still along its path.
template <typename Frame>
bool stands(const base::PathJet<Frame>& point, base::Axis axis) {
  return point.first[axis] == 0 && point.second[axis] == 0 && point.third[axis] == 0;
}

}  // namespace kerf::kinematics
