#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/axes.hpp"
#include "base/path_jet.hpp"
#include "motion/curve.hpp"
#include "planner/linkage.hpp"

namespace kerf::planner {

/// Where the driven axes stand at a point of a curve, and their derivatives by its parameter;
/// `rates` is nothing where these are not determined.
struct JointSample {
  base::TipPoint tip;
  base::JointPoint joints;
  std::optional<base::JointJet> rates;
};

/// What the driven axes do over a stretch of a curve, seen at its begin, its middle and its end.
///
///       q │        ,o                Three samples say nothing of what lies between them, unless
///       they
///         │     o´   \  ?            agree: what the derivatives at two of them promise for the
///         way │   ,´      `o             from one to the other must be what the values say,
///         └───┴────┴────┴── s
///             0    1    2            q1 - q0 = h/2 (q0' + q1') + h²/12 (q0" - q1"),  h = s1 - s0,
///
/// and likewise for q', over both halves; for q" by Simpson's rule over all three. The error of
/// both rules is of the order h⁵, so a stretch that is short beside everything the axes do agrees.
/// One in which an axis turns round, jumps, or runs through a peak between two samples does not:
/// there the values change and no derivative tells of it, or the other way round. An angle that has
/// gone round unseen is off by whole turns.
///
/// What is hidden in a stretch that agrees is a share kAgreement of what it shows, and as little of
/// the value itself as rounding makes of it.
class Stretch {
 public:
  static constexpr double kAgreement = 0.003;

  Stretch(const Linkage& linkage, const motion::Curve& curve) : linkage_(linkage), curve_(curve) {}

  /// Sees the curve from parameter `begin`, where `first` was seen, to `end`. The axes go on from
  /// `first`.
  void look(double begin, const JointSample& first, double end);
  [[nodiscard]] JointSample look_at(double at, const base::JointPoint& previous) const;

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const std::array<JointSample, 3>& samples() const { return samples_; }
  /// Every rate is determined, and the samples agree.
  [[nodiscard]] bool agrees() const;

 private:
  [[nodiscard]] bool agrees_within(const base::AxisVector& hidden) const;
  [[nodiscard]] base::AxisVector rounding() const;

  const Linkage& linkage_;
  const motion::Curve& curve_;
  double length_ = 0;
  std::array<JointSample, 3> samples_;
};

}  // namespace kerf::planner
