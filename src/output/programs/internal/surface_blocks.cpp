#include "output/programs/internal/surface_blocks.hpp"

#include <cmath>
#include <numbers>

#include "geometry/arc.hpp"
#include "motion/surface_path.hpp"

namespace kerf::output {
namespace {

using geometry::Vec2;
using motion::Surface;

bool is_face(const Surface& surface) { return surface.kind == Surface::Kind::face; }

bool is_same(const Surface& a, const Surface& b) {
  return a.kind == b.kind && a.first == b.first && a.zero_deg == b.zero_deg &&
         a.radius_mm == b.radius_mm;
}

Vec2 vec(const std::array<double, 2>& pair) { return {pair[0], pair[1]}; }

}  // namespace

bool SurfaceBlocks::can_say(const motion::SurfaceMove& move) const {
  const Surface& surface = move.surface;
  if (!is_face(surface)) return true;
  const bool goes_on = surface_ && is_same(*surface_, surface);
  return surface.centre_mm == 0 &&
         (goes_on || post_rounded(moves_.at()[surface.rotary] - surface.zero_deg) == 0);
}

void SurfaceBlocks::enter(const motion::SurfaceMove& move) {
  if (surface_ && is_same(*surface_, move.surface)) return;
  leave();
  surface_ = move.surface;
  const bool face = is_face(move.surface);
  body_.block(
      face ? "G12.1"
           : BlockText().code("G7.1").number('C', post_rounded(move.surface.radius_mm)).text());
  moves_.forget_feed();
}

void SurfaceBlocks::leave() {
  if (!surface_) return;
  body_.block(is_face(*surface_) ? "G13.1" : "G7.1 C0.");
  surface_.reset();
  moves_.forget_move(moves_.at());
}

// Every axis: where it stands in the plane is no place of the machine.
void SurfaceBlocks::place(const motion::SurfaceMove& move, BlockText& block) const {
  const motion::AxisSetup& axes = moves_.axes();
  for (std::size_t i = 0; i < axes.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    double value = move.to[axis];
    if (is_face(move.surface) && axis == move.surface.first) value = move.flat_to[0];
    if (is_face(move.surface) && axis == move.surface.rotary) value = move.flat_to[1];
    block.number(axes[axis].letter, post_rounded(value * axes[axis].count_per_mm()));
  }
}

// On a mantle arcs have a radius alone, negative for the long way round.
void SurfaceBlocks::round(const motion::SurfaceMove& move, BlockText& block) const {
  const Vec2 from = motion::flat_of(move.surface, moves_.at());
  const Vec2 centre = vec(move.about) - from;
  if (is_face(move.surface)) {
    block.number('I', post_rounded(centre.u)).number('J', post_rounded(centre.v));
    return;
  }
  const bool clockwise = move.direction == motion::Direction::clockwise;
  const double sweep = geometry::sweep_rad(from, vec(move.flat_to), vec(move.about), clockwise);
  block.number('R', post_rounded(sweep > std::numbers::pi ? -length(centre) : length(centre)));
}

void SurfaceBlocks::write(const motion::SurfaceMove& move) {
  enter(move);
  const bool clockwise = move.direction == motion::Direction::clockwise;
  BlockText block;
  block.code(!move.is_arc ? "G1" : clockwise ? "G2" : "G3");
  place(move, block);
  if (move.is_arc) round(move, block);
  const motion::SurfacePath path(moves_.axes(), moves_.at(), move, [](const motion::Curve&) {});
  moves_.feed(block, moves_.per_minute(move.feed, path.length()));
  body_.block(block.text());
  moves_.stand_at(move.to);
}

}  // namespace kerf::output
