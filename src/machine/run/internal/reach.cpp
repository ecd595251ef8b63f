#include "machine/run/internal/reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/stretch.hpp"

namespace kerf::machine {
namespace {

using base::AxisVector;
using base::JointPoint;
using base::TipPoint;
using kinematics::Fault;
using motion::Curve;
using planner::JointSample;
using planner::Stretch;

// Beyond a limit this counts as on it: what rounding makes of the joints.
constexpr double kOnLimit = 1e-9;

bool jumps(const Stretch& stretch) {
  const AxisVector way = stretch.samples()[2].joints - stretch.samples()[0].joints;
  return std::any_of(way.values.begin(), way.values.end(),
                     [](double d) { return std::fabs(d) > Reach::kJump; });
}

}  // namespace

/// One move, curve by curve, stretch by stretch.
class Reach::Follower {
 public:
  explicit Follower(const Reach& reach)
      : kinematics_(reach.kinematics_), linkage_(reach.linkage_), joints_(reach.joints_) {}

  /// False: there is a fault.
  bool follow(const Curve& curve, bool first, bool last);
  [[nodiscard]] std::optional<Fault> fault() const;
  [[nodiscard]] const JointPoint& joints() const { return joints_; }
  [[nodiscard]] const std::optional<Caution>& caution() const { return caution_; }

 private:
  // More halvings than lengths of doubles have.
  static constexpr std::size_t kMostEnds = 128;

  bool holds(const Stretch& stretch);
  void blame(const Curve& curve, double begin, const Stretch& stretch);
  void pass(const Stretch& stretch);
  [[nodiscard]] bool stays_in_sight(const Stretch& stretch) const;
  [[nodiscard]] double excess(const JointPoint& joints) const;

  const kinematics::Kinematics& kinematics_;
  const planner::Linkage& linkage_;
  JointPoint joints_;
  std::optional<Fault> fault_;
  JointPoint beyond_;  // the joints that are farthest beyond their limits
  double most_beyond_ = kOnLimit;
  std::optional<Caution> caution_;
};

// Whether there are joints for each sample.
bool Reach::Follower::holds(const Stretch& stretch) {
  for (const JointSample& sample : stretch.samples()) {
    auto joints = kinematics_.follow(sample.tip, joints_);
    if (joints) continue;
    fault_ = std::move(joints.error());
    return false;
  }
  return true;
}

// How far a joint is beyond its range; 0 within.
double Reach::Follower::excess(const JointPoint& joints) const {
  double most = 0;
  for (std::size_t m = 0; m < kinematics_.size(); ++m) {
    const kinematics::Joint& joint = kinematics_.joints()[m];
    most = std::max({most, joints.values[m] - joint.high, joint.low - joints.values[m]});
  }
  return most;
}

// Whether no joint can be farther beyond a limit between the samples than at one of them.
bool Reach::Follower::stays_in_sight(const Stretch& stretch) const {
  const double h = stretch.length() / 2;
  for (std::size_t m = 0; m < kinematics_.size(); ++m) {
    const kinematics::Joint& joint = kinematics_.joints()[m];
    double low = stretch.samples()[0].joints.values[m];
    double high = low;
    double bend = 0;
    for (const JointSample& sample : stretch.samples()) {
      low = std::min(low, sample.joints.values[m]);
      high = std::max(high, sample.joints.values[m]);
      bend = std::max(bend, std::fabs(sample.rates->second.values[m]));
    }
    const double rise = h * h / 4 * bend;
    const bool seen = high > joint.high + kOnLimit || low < joint.low - kOnLimit;
    const bool possible = high + rise > joint.high || low - rise < joint.low;
    if (rise > kOnLimit && possible && !seen) return false;
  }
  return true;
}

// The sentence of a stretch that is as short as can be and yet not smooth.
void Reach::Follower::blame(const Curve& curve, double begin, const Stretch& stretch) {
  fault_ = Fault{Fault::Kind::singular, "joints would have to jump"};
  for (std::size_t i = 0; i < stretch.samples().size(); ++i) {
    const double at = begin + stretch.length() * static_cast<double>(i) / 2;
    const auto rates = kinematics_.along(curve.jet(at), stretch.samples()[i].joints);
    if (!rates) fault_ = rates.error();
  }
}

void Reach::Follower::pass(const Stretch& stretch) {
  for (const JointSample& sample : stretch.samples()) {
    if (!caution_) {
      if (auto sentence = kinematics_.caution(sample.joints))
        caution_ = {*std::move(sentence), sample.tip};
    }
    if (const double most = excess(sample.joints); most > most_beyond_) {
      most_beyond_ = most;
      beyond_ = sample.joints;
    }
  }
  joints_ = stretch.samples()[2].joints;
}

bool Reach::Follower::follow(const Curve& curve, bool first, bool last) {
  Stretch stretch(linkage_, curve);
  double begin = 0;
  JointSample at = stretch.look_at(begin, joints_);
  std::array<double, kMostEnds> ends{curve.length()};
  for (std::size_t left = 1; left > 0;) {
    const double end = ends[left - 1];
    stretch.look(begin, at, end);
    if (!holds(stretch)) return false;
    const bool smooth = stretch.agrees();
    const bool at_end_of_move = (first && begin == 0) || (last && left == 1);
    const double shortest = at_end_of_move ? kAtEnd_mm : kShortest_mm;
    const bool divisible = stretch.length() > shortest && left < kMostEnds;
    if (divisible && !(smooth && stays_in_sight(stretch))) {
      ends[left++] = begin + stretch.length() / 2;
      continue;
    }
    if (!smooth && (!at_end_of_move || jumps(stretch))) {
      blame(curve, begin, stretch);
      return false;
    }
    pass(stretch);
    at = stretch.samples()[2];
    begin = end;
    --left;
  }
  return true;
}

std::optional<Fault> Reach::Follower::fault() const {
  if (most_beyond_ > kOnLimit) return kinematics_.beyond_limits(beyond_);
  return fault_;
}

std::optional<Fault> Reach::objection(const TipPoint& from, const motion::Motion& move,
                                      JointPoint& end) {
  if (const TipPoint* const to = motion::target_of(move)) {
    auto joints = kinematics_.follow(*to, joints_);
    if (!joints) return std::move(joints.error());
  }
  const auto curves = curves_.of(from, move);
  Follower follower(*this);
  for (const Curve& curve : curves) {
    if (!follower.follow(curve, &curve == &curves.front(), &curve == &curves.back())) break;
  }
  if (auto fault = follower.fault()) return fault;
  end = follower.joints();
  caution_ = follower.caution();
  return {};
}

}  // namespace kerf::machine
