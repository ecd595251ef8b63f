#include "stock/cutting/work_frame.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace kerf::stock {
namespace {

/// `v` turned about a unit vector (Rodrigues).
Vec3 turned_about(Vec3 v, Vec3 axis, double angle_deg) {
  const auto [s, c] = geometry::sine_cosine_deg(angle_deg);
  if (geometry::cross(axis, v) == Vec3{}) return v;  // nothing of it is rounded
  return c * v + s * geometry::cross(axis, v) + ((1 - c) * geometry::dot(axis, v)) * axis;
}

}  // namespace

WorkFrame::WorkFrame(const motion::AxisSetup& axes, std::vector<WorkTurn> turns)
    : linear_{axes.find('X'), axes.find('Y'), axes.find('Z')}, turns_(std::move(turns)) {}

Vec3 WorkFrame::in_space(const base::AxisVector& vector) const {
  const auto of = [&](std::size_t i) { return linear_[i] ? vector[*linear_[i]] : 0.0; };
  return {of(0), of(1), of(2)};
}

Vec3 WorkFrame::turned(Vec3 direction, const base::AxisVector& tip) const {
  for (const WorkTurn& turn : turns_)
    direction = turned_about(direction, turn.direction, tip[turn.axis]);
  return direction;
}

WorkFrame WorkFrame::still() const {
  WorkFrame still = *this;
  still.turns_.clear();
  return still;
}

Pose WorkFrame::pose(const base::TipPoint& tip, Vec3 axis) const {
  Pose pose{in_space(tip), axis};
  for (const WorkTurn& turn : turns_) {
    pose.tip = turn.point + turned_about(pose.tip - turn.point, turn.direction, tip[turn.axis]);
    pose.axis = turned_about(pose.axis, turn.direction, tip[turn.axis]);
  }
  pose.tip = pose.tip - zero_;
  return pose;
}

double WorkFrame::turn_rad(const base::AxisVector& a, const base::AxisVector& b) const {
  double sum = 0;
  for (const WorkTurn& turn : turns_) sum += std::fabs(b[turn.axis] - a[turn.axis]);
  return geometry::radians(sum);
}

double WorkFrame::lever(const base::AxisVector& a, const base::AxisVector& b) const {
  double chain = 0;
  for (const WorkTurn& turn : turns_) chain += geometry::length(turn.point);
  return chain + std::max(geometry::length(in_space(a)), geometry::length(in_space(b)));
}

bool WorkFrame::turns_between(const base::AxisVector& a, const base::AxisVector& b) const {
  for (const WorkTurn& turn : turns_) {
    if (a[turn.axis] != b[turn.axis]) return true;
  }
  return false;
}

}  // namespace kerf::stock
