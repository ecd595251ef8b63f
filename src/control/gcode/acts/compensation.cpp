#include "control/gcode/acts/compensation.hpp"

#include <array>
#include <cmath>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using geometry::Vec2;

constexpr double kMostRadius = 9999.999;  // mm, geometry and wear together

// From the centre of the nose to the imaginary tip, along Z and X, by its direction.
constexpr std::array<Vec2, 10> kTips = {
    {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}};

bool is_straight(Meaning motion) { return motion == Meaning::rapid || motion == Meaning::line; }

// The radius that D selects, mm.
double radius_of(const State& state, std::int64_t number) {
  const ToolOffset& tool = state.memory.tools[static_cast<std::size_t>(number)];
  if (state.parameters.offset_memory != 'C')
    return base::tidy(tool.length_geometry + tool.length_wear);
  return base::tidy(tool.radius_geometry + tool.radius_wear);
}

}  // namespace

void tell_rough_without_nose(State& state) {
  state.assume(Assumed::rough_without_nose,
               "G71 to G73 do not compensate the nose radius: only G70 does");
}

void tell_lost_corner(State& state) {
  if (!state.path.gave_up_corner()) return;
  state.assume(Assumed::lost_corner,
               "more than two blocks without a move: the compensation ends the move before them "
               "perpendicular, as if none followed");
}

Compensation::Tool Compensation::mill() const {
  const std::int64_t number = state_.words.radius_offset;
  return {number, radius_of(state_, number), {}, "D" + std::to_string(number)};
}

// Number 0 is no offset. The direction belongs to the number of the wear.
Compensation::Tool Compensation::nose() const {
  const std::int64_t number = state_.words.turning_offset;
  const auto& rows = state_.memory.turning;
  const TurningOffset& row = rows[static_cast<std::size_t>(number)];
  const auto& geometry = rows[static_cast<std::size_t>(state_.words.geometry_offset)].geometry;
  return {number, base::tidy(geometry.radius + row.wear.radius),
          kTips[static_cast<std::size_t>(row.tip)], "R of offset " + std::to_string(number)};
}

bool Compensation::apply(const Words& words, bool switched) {
  const bool off = state_.modal[Group::compensation] == Meaning::compensation_off;
  if (state_.reads_shape) {
    if (switched && !off) tell_rough_without_nose(state_);
    return true;
  }
  if (off) return !switched || !state_.path.compensating() || cancel(words);
  return !(switched || may_have_changed(words)) || compensate(switched);
}

// CRC-13. Of a lathe also whatever writes the offset in force.
bool Compensation::may_have_changed(const Words& words) const { return turns() || words.has('D'); }

bool Compensation::cancel(const Words& words) {
  std::optional<Vec2> wall;
  const bool straight = is_straight(state_.modal[Group::motion]);
  if (straight && !read_wall(words, wall)) return false;
  if (!straight && words.has_any(targets_.letters()))
    return state_.alarms.raise(Code::arc_at_start_up);
  state_.path.end_compensation(wall);
  return true;
}

// CRC-12: I and J of a G40 block.
bool Compensation::read_wall(const Words& words, std::optional<Vec2>& wall) {
  const auto plane = state_.plane();
  if (!plane) return true;
  const auto read = [&](char letter, double& mm) {
    return !words.has(letter) || state_.values.length(words[letter], mm);
  };
  Vec2 direction;
  if (!read(plane->first_offset, direction.u) || !read(plane->second_offset, direction.v))
    return false;
  if (geometry::length(direction) > 0) wall = direction;
  return true;
}

bool Compensation::compensate(bool switched) {
  const auto plane = state_.plane();
  if (!plane)
    return state_.alarms.raise(Code::illegal_plane_axis, "the machine lacks an axis of the plane");
  const Transform& transform = state_.coordinates.transform();
  if (transform.rotated() && !transform.rotates(*plane))  // TRF-3
    return state_.alarms.raise(Code::illegal_transform_plane);
  const Tool tool = turns() ? nose() : mill();
  if (std::fabs(tool.radius) > kMostRadius)
    return state_.alarms.raise(Code::illegal_offset_value,
                               tool.name + " is " + base::number_text(tool.radius));
  if (tool.number == 0 || tool.radius == 0) return without_radius(tool, switched);
  const bool left = state_.modal[Group::compensation] == Meaning::compensation_left;
  return compensate_for(tool, left != transform.reverses(*plane), *plane);
}

// A negative radius swaps the sides, the nose is where it was.
bool Compensation::compensate_for(const Tool& tool, bool left, const motion::PlaneAxes& plane) {
  Cutter cutter{.offset = left ? tool.radius : -tool.radius};
  if (state_.modal.plane() == motion::Plane::zx) cutter.tip = std::fabs(tool.radius) * tool.tip;
  if (!state_.path.compensates(cutter)) state_.path.compensate(plane, cutter);
  return true;
}

// D0 cancels (CRC-1, CRC-12), and T with the offset 0.
bool Compensation::without_radius(const Tool& tool, bool switched) {
  if (switched && turns()) {
    state_.assume(Assumed::no_nose,
                  "G41 or G42 without an offset, or with nose radius 0, compensates nothing");
  } else if (switched && tool.number == 0) {
    state_.assume(Assumed::no_offset + 500, "G41 or G42 without an offset number: radius 0");
  }
  if (state_.path.compensating()) state_.path.end_compensation(std::nullopt);
  return true;
}

}  // namespace kerf::control
