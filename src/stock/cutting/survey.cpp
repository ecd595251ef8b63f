#include "stock/cutting/survey.hpp"

#include <algorithm>
#include <limits>

namespace kerf::stock {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
// A tool that is tilted by less stands upright: what the sine of a rounded right angle leaves.
constexpr double kUpright = 1e-12;

Survey::Extents none() {
  return {.low = {kFar, kFar, kFar}, .high = {-kFar, -kFar, -kFar}, .across = {}};
}

void take_in(const Bounds& box, Survey::Extents& extents) {
  Vec3& low = extents.low;
  Vec3& high = extents.high;
  low = {std::min(low.x, box.low.x), std::min(low.y, box.low.y), std::min(low.z, box.low.z)};
  high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y), std::max(high.z, box.high.z)};
}

bool is_axial(const motion::Motion& motion, Vec3 way) {
  return std::holds_alternative<motion::Line>(motion.action) && way.x == 0 && way.y == 0;
}

}  // namespace

void Survey::take(const motion::Motion& motion) {
  if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) {
    if (!changes_tool_) tools_.clear();  // without a tool nothing is cut
    changes_tool_ = true;
    tool_ = change->tool;
    return;
  }
  const base::TipPoint* const to = motion::target_of(motion);
  if (to == nullptr) return;
  if (motion::is_cut(motion)) cut(motion);
  at_ = *to;
}

void Survey::cut(const motion::Motion& motion) {
  Extents& extents = tools_.try_emplace(tool_, none()).first->second;
  sweeps_.clear();
  base::TipPoint from = at_;
  for (const motion::Curve& curve : curves_.of(at_, motion)) {
    maker_.add(from, curve, {}, 0, sweeps_);
    from = curve.end();
  }
  for (const Sweep& sweep : sweeps_) {
    take_in(bounds(sweep.way), extents);
    extents.turned = extents.turned || sweep.axis.z < 1 - kUpright;
  }
  const base::TipPoint& to = *motion::target_of(motion);
  if (is_axial(motion, frame_.in_space(to - at_))) return;
  extents.axial = false;
  const double z = frame_.pose(to).tip.z;
  extents.across = std::max(extents.across.value_or(z), z);
}

}  // namespace kerf::stock
