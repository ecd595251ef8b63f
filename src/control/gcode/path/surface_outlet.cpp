#include "control/gcode/path/surface_outlet.hpp"

#include "base/decimal.hpp"
#include "motion/surface_path.hpp"

namespace kerf::control {

using base::TipPoint;
using geometry::Vec2;
using motion::Motion;

bool SurfaceOutlet::let_out(const Motion& motion, const TipPoint& from, const base::Place* place) {
  const TipPoint* const to = motion::target_of(motion);
  if (!surface_ || to == nullptr) return outlet_.let_out(motion, from, place);
  const Motion move = translated(motion);
  if (!outlet_.let_out(move, tip_, place)) return false;
  tip_ = *motion::target_of(move);
  return true;
}

bool SurfaceOutlet::admits(const Motion& motion, const TipPoint& from) {
  const bool moves = motion::target_of(motion) != nullptr;
  return surface_ && moves ? outlet_.admits(translated(motion), tip_)
                           : outlet_.admits(motion, from);
}

void SurfaceOutlet::begin(const motion::Surface& surface, const TipPoint& tip) {
  surface_ = surface;
  tip_ = tip;
}

TipPoint SurfaceOutlet::in_plane(TipPoint tip) const {
  const Vec2 at = motion::flat_of(*surface_, tip);
  tip[surface_->first] = at.u + surface_->centre_mm;
  tip[surface_->rotary] = at.v;
  return tip;
}

// The plane of a face has its origin in the centre.
Vec2 SurfaceOutlet::flat(double first, double rotary) const {
  return {first - surface_->centre_mm, rotary};
}

Motion SurfaceOutlet::translated(const Motion& motion) const {
  const TipPoint& to = *motion::target_of(motion);
  motion::SurfaceMove move;
  move.to = to;
  move.surface = *surface_;
  const Vec2 end = flat(to[surface_->first], to[surface_->rotary]);
  move.flat_to = {end.u, end.v};
  if (const auto* const line = std::get_if<motion::Line>(&motion.action)) move.feed = line->feed;
  if (const auto* const arc = std::get_if<motion::Arc>(&motion.action)) {
    const Vec2 centre = flat(arc->center[0], arc->center[1]);
    move.is_arc = true;
    move.about = {centre.u, centre.v};
    move.feed = arc->feed;
    move.direction = arc->direction;
  }
  move.to = motion::end_of(axes_, tip_, move);
  for (double& value : move.to.values) value = base::tidy(value);
  Motion translated = motion;
  translated.action = move;
  return translated;
}

}  // namespace kerf::control
