#include "control/core/stroke_limits.hpp"

#include "base/decimal.hpp"
#include "motion/motion_extent.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::Code;
using base::TipPoint;

// Beyond a limit by no more than this counts as on it, as with joints.
constexpr double kOnLimit = 1e-9;

}  // namespace

std::optional<Refusal> StrokeLimits::refusal(Axis axis, double target) const {
  const motion::AxisConfig& config = axes_[axis];
  if (!on_ || !(config.travel_min < config.travel_max)) return {};
  const double machine = target + (length_ != nullptr ? (*length_)[axis] : 0);
  const double count = config.count_per_mm();
  const bool high = machine > config.travel_max + kOnLimit;
  if (!high && !(machine < config.travel_min - kOnLimit)) return {};
  return Refusal{high ? Code::overtravel_plus : Code::overtravel_minus,
                 std::string(1, config.letter) + " would go to " +
                     base::number_text(base::tidy(machine * count)) + ", the limit is " +
                     base::number_text((high ? config.travel_max : config.travel_min) * count)};
}

std::optional<Refusal> StrokeLimits::refusal(const TipPoint& from,
                                             const motion::Motion& move) const {
  if (!on_ || motion::target_of(move) == nullptr) return {};
  const motion::MotionExtent extent = motion::extent_of(axes_, from, move);
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (extent.high[axis] > from[axis]) {
      if (auto beyond = refusal(axis, extent.high[axis])) return beyond;
    }
    if (extent.low[axis] < from[axis]) {
      if (auto beyond = refusal(axis, extent.low[axis])) return beyond;
    }
  }
  return {};
}

}  // namespace kerf::control
