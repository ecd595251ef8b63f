#include "control/gcode/cycles/level_passes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::control {
namespace {

TurningProfile profile_of(const TurningShape& shape, const TurningFrame& frame,
                          const RoughSettings& settings) {
  auto pieces = monotone_pieces(shape, frame, settings.allowance);
  drop_way_back(pieces);
  return TurningProfile(std::move(pieces));
}

// How many levels it takes down to `depth_mm`, where rounding makes none.
std::uint64_t count_levels(double depth_mm, double step_mm) {
  const double levels = std::ceil((depth_mm - kSameLevel_mm) / step_mm);
  return levels > 0 ? static_cast<std::uint64_t>(levels) : 0;
}

}  // namespace

LevelPasses::LevelPasses(TurningShape shape, const RoughSettings& settings)
    : Roughing(std::move(shape), settings),
      profile_(profile_of(this->shape(), frame(), settings)),
      levels_(count_levels(corner().v - first().v, this->settings().depth_mm)) {}

bool LevelPasses::cut() {
  if (made_ == levels_) return false;
  count_pass();
  const double height = ++made_ == levels_ ? first().v : level(made_);
  const double end = end_of(height);
  const double away = height + retreat_mm();
  approach({corner().u, height});
  feed_to({end, height});
  rapid_to({end - retreat_mm(), away});
  rapid_to({corner().u, away});
  return true;
}

// Never behind C: a shape that begins there is not to be turned, and nothing is cut backwards.
double LevelPasses::end_of(double level) const {
  if (profile_.empty()) return corner().u;
  const std::size_t wall = profile_.first_above(0, level);
  const double end =
      wall == profile_.size() ? profile_.back().to.u : profile_[wall].at_height(level).u;
  return std::max(end, corner().u);
}

}  // namespace kerf::control
