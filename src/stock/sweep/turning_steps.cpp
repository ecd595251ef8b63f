#include "stock/sweep/turning_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kerf::stock {
namespace {

constexpr int kFewestHalvings = 2;  // halvings
constexpr int kMostHalvings = 16;

double size(Vec3 v) { return std::sqrt(dot(v, v)); }

class Division {
 public:
  Division(const std::function<ToolPose(double)>& pose, double lever_mm, double tolerance_mm)
      : pose_(pose),
        lever_(lever_mm),
        tolerance_(tolerance_mm),
        most_turn_(std::sqrt(8 * tolerance_mm / std::max(lever_mm, tolerance_mm))) {}

  void divide(double from, const ToolPose& a, double to, const ToolPose& b, int halvings) {
    const bool is_enough = halvings >= kFewestHalvings && is_straight(from, a, to, b);
    if (is_enough || halvings >= kMostHalvings) {
      steps_.push_back({a.axis, {a.tip, b.tip, b.axis}});
      return;
    }
    const double middle = from + (to - from) / 2;
    const ToolPose between = pose_(middle);
    divide(from, a, middle, between, halvings + 1);
    divide(middle, between, to, b, halvings + 1);
  }
  [[nodiscard]] std::vector<TurningStep> take() { return std::move(steps_); }

 private:
  /// Of the points of the tool those furthest from the tip leave their chords most.
  [[nodiscard]] bool is_straight(double from, const ToolPose& a, double to,
                                 const ToolPose& b) const {
    if (size(b.axis - a.axis) > most_turn_) return false;
    constexpr std::array kShares{0.25, 0.5, 0.75};
    return std::all_of(kShares.begin(), kShares.end(), [&](double share) {
      const ToolPose now = pose_(from + share * (to - from));
      const double tip = size(now.tip - (a.tip + share * (b.tip - a.tip)));
      const double axis = size(now.axis - (a.axis + share * (b.axis - a.axis)));
      return tip + lever_ * axis <= tolerance_;
    });
  }

  const std::function<ToolPose(double)>& pose_;
  double lever_;
  double tolerance_;
  double most_turn_;
  std::vector<TurningStep> steps_;
};

}  // namespace

std::vector<TurningStep> turning_steps(const std::function<ToolPose(double)>& pose, double lever_mm,
                                       double tolerance_mm) {
  Division division(pose, lever_mm, tolerance_mm);
  division.divide(0, pose(0), 1, pose(1), 0);
  return division.take();
}

}  // namespace kerf::stock
