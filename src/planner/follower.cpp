#include "planner/follower.hpp"

#include <array>

#include "planner/stretch.hpp"

namespace kerf::planner {

bool Follower::can_follow(const motion::Curve& curve) {
  if (linkage_ == nullptr) return true;
  constexpr std::size_t kMostEnds = 64;
  std::array<double, kMostEnds> ends{curve.length()};
  Stretch stretch(*linkage_, curve);
  double begin = 0;
  JointSample at = stretch.look_at(begin, joints_);
  joints_ = at.joints;
  for (std::size_t left = 1; left > 0;) {
    const double end = ends[left - 1];
    stretch.look(begin, at, end);
    if (stretch.agrees()) {
      at = stretch.samples()[2];
      begin = end;
      --left;
    } else if (stretch.length() > kShortest && left < kMostEnds) {
      ends[left++] = begin + stretch.length() / 2;
    } else {
      return false;
    }
  }
  return true;
}

std::optional<base::JointJet> Follower::driven(const base::TipJet& tip) {
  if (linkage_ == nullptr)
    return base::JointJet{base::JointPoint(tip.value.numbers()), tip.first, tip.second, tip.third};
  joints_ = linkage_->joints(tip.value, joints_);
  return linkage_->along(tip, joints_);
}

}  // namespace kerf::planner
