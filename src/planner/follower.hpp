#pragma once

#include <optional>

#include "base/path_jet.hpp"
#include "motion/curve.hpp"
#include "planner/linkage.hpp"

namespace kerf::planner {

/// Asks, while the path is being made, what the driven axes would do on it. Programmed lines and
/// arcs can be driven, which was seen before; curves that are made of them by the tolerance may
/// leave the workspace at its rim, or come too near to a singular place.
class Follower {
 public:
  /// Shortest stretch that is looked at, mm, or degrees where only rotary axes move: what is not
  /// smooth over it cannot be driven.
  static constexpr double kShortest = 1e-6;

  /// `linkage` may be null: the driven axes are the program's. It must outlive the follower.
  explicit Follower(const Linkage* linkage) : linkage_(linkage) {
    if (linkage_ != nullptr) joints_ = linkage_->start();
  }

  [[nodiscard]] bool linked() const { return linkage_ != nullptr; }
  /// Whether the driven axes can follow a curve, from near where they were asked about last.
  [[nodiscard]] bool can_follow(const motion::Curve& curve);
  /// Derivatives of the driven axes from those of the tip; nothing where they are not determined.
  [[nodiscard]] std::optional<base::JointJet> driven(const base::TipJet& tip);

 private:
  const Linkage* linkage_;
  base::JointPoint joints_;
};

}  // namespace kerf::planner
