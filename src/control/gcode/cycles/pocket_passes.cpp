#include "control/gcode/cycles/pocket_passes.hpp"

#include <algorithm>
#include <utility>

namespace kerf::control {
namespace {

using geometry::Vec2;

// A part that is shorter is an arc that touches the level: 1e-13 of rounding in the height of an
// arc of 500 mm make as much.
constexpr double kTouches_mm = 1e-5;

MonotonePiece line(Vec2 from, Vec2 to) { return {.from = from, .to = to}; }

// From beside C to P0, along the shape, and up again where it ends.
TurningProfile profile_with_pockets(const TurningShape& shape, const TurningFrame& frame,
                                    const RoughSettings& settings) {
  const Vec2 corner = frame.local(shape.start + settings.allowance);
  auto pieces = monotone_pieces(shape, frame, settings.allowance);
  drop_way_back(pieces);
  if (pieces.empty()) return TurningProfile({});
  const Vec2 first = pieces.front().from;
  if (first.u != corner.u) pieces.insert(pieces.begin(), line({corner.u, first.v}, first));
  const Vec2 last = pieces.back().to;
  if (last.v < corner.v) pieces.push_back(line(last, {last.u, corner.v}));
  return TurningProfile(std::move(pieces));
}

}  // namespace

PocketPasses::PocketPasses(TurningShape shape, const RoughSettings& settings)
    : Roughing(std::move(shape), settings),
      profile_(profile_with_pockets(this->shape(), frame(), settings)) {
  enter(corner().v, 0, 0, profile_.size());
}

// The part at `level`, the one of that number, has been cut: opens what is deeper.
void PocketPasses::enter(double level, std::uint64_t number, std::size_t first, std::size_t end) {
  const double deepest = profile_.lowest(first, end);
  double next = this->level(number + 1);
  if (next < deepest + kSameLevel_mm) next = deepest;
  if (next < level - kSameLevel_mm) open_.push_back({level, next, number + 1, first, end});
}

bool PocketPasses::cut() {
  while (!open_.empty()) {
    Part part;
    const bool found = take_part(open_.back(), part);
    const Pocket pocket = open_.back();
    // A pocket whose last part is being cut is done with, so that never more of them are open than
    // the shape has parts beside each other, however many levels there are.
    Part other;
    if (!found || !find_part(pocket, other)) open_.pop_back();
    if (!found) continue;
    cut_part(part, pocket);
    enter(pocket.level, pocket.number, part.first, part.last + 1);
    return true;
  }
  return false;
}

bool PocketPasses::find_part(const Pocket& pocket, Part& part) const {
  const std::size_t first = profile_.first_at_or_below(pocket.next, pocket.level);
  if (first >= pocket.end) return false;
  part.first = first;
  part.at_corner = first == 0 && profile_[0].from.v <= pocket.level + kSameLevel_mm;
  part.begin = part.at_corner ? profile_[0].from : profile_[first].at_height(pocket.level);
  const std::size_t wall = profile_.first_above(part.at_corner ? 0 : first + 1, pocket.level);
  part.last = std::min(wall, profile_.size() - 1);
  part.end = wall < profile_.size() ? profile_[wall].at_height(pocket.level) : profile_.back().to;
  return true;
}

// The next part that has a length. Behind the wall that ends a part the shape is above the level.
bool PocketPasses::take_part(Pocket& pocket, Part& part) const {
  while (find_part(pocket, part)) {
    pocket.next = part.last + 1;
    if (part.end.u - part.begin.u > kTouches_mm) return true;
  }
  return false;
}

void PocketPasses::cut_part(const Part& part, const Pocket& pocket) {
  count_pass();
  if (part.at_corner) {
    begin_at_corner(pocket.level);
  } else {
    come_down(part, pocket.above);
  }
  feed_to({part.end.u, pocket.level});
  climb(part.last, pocket.above);
  rapid_to({at().u, at().v + retreat_mm()});
}

void PocketPasses::begin_at_corner(double level) {
  rapid_to({corner().u, at().v});
  approach({corner().u, level});
}

// Over W, where the falling wall begins or is as high as the level above; then down along it.
void PocketPasses::come_down(const Part& part, double above) {
  std::size_t i = part.first;
  while (i > 0 && profile_[i].from.v < above - kSameLevel_mm && profile_[i - 1].falls()) --i;
  const Vec2 top = profile_[i].from.v > above ? profile_[i].at_height(above) : profile_[i].from;
  const double clear = above + retreat_mm();
  if (at().v < clear - kSameLevel_mm) rapid_to({at().u, clear});
  rapid_to({top.u, at().v});
  feed_to(top);
  for (; i < part.first; ++i) feed_along(profile_[i], profile_[i].to);
  feed_along(profile_[i], part.begin);
}

void PocketPasses::climb(std::size_t piece, double above) {
  for (; piece < profile_.size() && profile_[piece].rises(); ++piece) {
    const MonotonePiece& wall = profile_[piece];
    if (wall.to.v > above) return feed_along(wall, wall.at_height(above));
    feed_along(wall, wall.to);
    if (wall.to.v > above - kSameLevel_mm) return;
  }
}

void PocketPasses::leave() {
  rapid_to({at().u, corner().v});
  rapid_to({corner().u, at().v});
}

}  // namespace kerf::control
