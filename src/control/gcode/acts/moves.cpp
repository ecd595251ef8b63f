#include "control/gcode/acts/moves.hpp"

#include <bit>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/acts/surfaces.hpp"
#include "geometry/arc.hpp"
#include "motion/feed.hpp"
#include "motion/spindle_speed.hpp"
#include "motion/thread_speed.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisVector;
using base::Code;
using base::PathPoint;
using base::ProgramPoint;
using geometry::Vec2;

// For messages: to 0.0001 mm.
std::string millimetres(double value) { return base::number_text(std::round(value * 1e4) / 1e4); }

constexpr double kForTwoPercent = 2.912023005428146;  // -1 - ln 0.02
constexpr double kMostCoordinate = 999999.999;
constexpr int kMostHelixAxes = 2;
constexpr std::uint32_t kCentreLetters = Words::mask('I') | Words::mask('J') | Words::mask('K');

// G60: where the last part of the way to `end` begins, which is as long as parameter 5440 and goes
// in the direction of its sign on the machine: neither mirror image nor rotation turns it. Nothing:
// no axis has one, as those that stand still.
std::optional<PathPoint> begin_of_last_part(const State& state, const PathPoint& end) {
  if (state.one_shot != Meaning::single_direction) return {};
  const PathPoint from = state.coordinates.path();
  PathPoint begin = end;
  for (std::size_t i = 0; i < state.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const double overrun = state.parameters.overrun[state.axes[axis].letter];
    if (end[axis] != from[axis]) begin[axis] = base::tidy(end[axis] - overrun);
  }
  return begin == end ? std::nullopt : std::optional(begin);
}

}  // namespace

bool Moves::has_feed(const Words& words) {
  if (state_.modal.feed_mode() == motion::FeedMode::inverse_time && !words.has('F'))
    return state_.alarms.raise(Code::no_feed_inverse_time);
  if (state_.codes.habits().tool_brings_offset && !state_.turns() &&
      state_.modal.feed_mode() == motion::FeedMode::per_revolution)
    state_.assume(Assumed::no_spindle_turns,
                  "feed per revolution while no spindle turns: its time is that of the last S, or "
                  "of 1000 rpm");
  return state_.words.feed > 0 ||
         state_.alarms.raise(Code::feed_zero,
                             words.has('F') ? "F is 0" : "no F has been commanded");
}

void Moves::apply_length(base::AxisSet named) {
  if (state_.codes.habits().tool_brings_offset) return apply_tool_offset(named);
  if (base::contains(named, state_.length_axis)) {
    state_.set_length(state_.length_axis, state_.wanted_length);
  }
}

// LAT-7: with the next move of each axis.
void Moves::apply_tool_offset(base::AxisSet named) {
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (base::contains(named, axis)) state_.set_length(axis, state_.wanted_offset[axis]);
  }
}

bool Moves::check_limits(const AxisVector& target) {
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (!(target[axis] <= kMostCoordinate && target[axis] >= -kMostCoordinate)) {
      return state_.alarms.raise(Code::position_overflow, std::string(1, state_.axes[axis].letter) +
                                                              base::number_text(target[axis]));
    }
    if (state_.path.surface() != nullptr) continue;  // what the axes do there is seen on its way
    if (const auto beyond = state_.strokes.refusal(axis, target[axis]))
      return state_.alarms.raise(beyond->code, beyond->sentence);
  }
  return true;
}

bool Moves::finish(const Target& target, const PathPoint& path) {
  state_.coordinates.move_to(target.program, path);
  state_.moved_since_m29 = true;
  return true;
}

bool Moves::rapid_to(const ProgramPoint& program) {
  const PathPoint path = state_.coordinates.path_of(program);
  if (!check_limits(path) || !state_.path.straight(state_.rapid(on_path(path)))) return false;
  return finish({program, 0}, path);
}

bool Moves::position(const ProgramPoint& program) {
  const PathPoint end = state_.coordinates.path_of(program);
  if (const auto turn = begin_of_last_part(state_, end)) {
    if (!check_limits(end) || !check_limits(*turn) ||
        !state_.path.straight(state_.rapid(on_path(*turn))))
      return false;
  }
  return rapid_to(program);
}

bool Moves::line_to(const ProgramPoint& program, const motion::Feed& feed) {
  const PathPoint path = state_.coordinates.path_of(program);
  if (!check_limits(path) || !state_.path.straight(motion::Line{on_path(path), feed})) return false;
  return finish({program, 0}, path);
}

// G01 without axes: the beam of a laser goes on where it stands (docs/drives.md, M03, M04 and S).
void Moves::cut_standing(const Words& words) {
  if (!state_.axes.beam || !words.has_g(Meaning::line) ||
      !motion::Spindle::turns(state_.words.turning))
    return;
  motion::Spindle spindle = state_.spindle();
  spindle.cuts_standing = true;
  state_.path.act(spindle);
}

// G60 is a positioning, whatever motion is in force.
Meaning Moves::motion_mode() const {
  return state_.one_shot == Meaning::single_direction ? Meaning::rapid
                                                      : state_.modal[Group::motion];
}

bool Moves::execute(const Words& words, bool& moved) {
  const Meaning mode = motion_mode();
  const bool circular = mode == Meaning::arc_clockwise || mode == Meaning::arc_counterclockwise;
  const bool centre_alone = circular && words.has_any(kCentreLetters | Words::mask('R'));
  if (!words.has_any(targets_.letters()) && !centre_alone) {
    cut_standing(words);
    return true;
  }
  Target target;
  if (!targets_.read(words, target) || !check_axes(target) || !suits_surface(state_, mode))
    return false;
  moved = true;
  const bool threads = mode == Meaning::thread || mode == Meaning::thread_of_variable_lead;
  if (circular || threads) {
    apply_length(target.named);
    return circular ? arc(words, mode == Meaning::arc_clockwise, target) : thread(words, target);
  }
  return straight(words, target);
}

// G-4
bool Moves::check_axes(const Target& target) {
  if (state_.axes.count() <= static_cast<std::size_t>(state_.parameters.simultaneous_axes) ||
      std::popcount(target.named) <= state_.parameters.simultaneous_axes)
    return true;
  return state_.alarms.raise(
      Code::too_many_axes,
      std::to_string(state_.parameters.simultaneous_axes) + " axes can move together");
}

bool Moves::straight(const Words& words, const Target& target) {
  apply_length(target.named);
  const PathPoint path = state_.coordinates.path_of(target.program);
  if (!check_limits(path)) return false;
  if (begin_of_last_part(state_, path)) return position(target.program);
  if (motion_mode() == Meaning::rapid) {
    if (!state_.path.move(state_.coordinates.path(), state_.rapid(on_path(path)))) return false;
  } else {
    if (!has_feed(words) ||
        !state_.path.move(state_.coordinates.path(), motion::Line{on_path(path), feed()}))
      return false;
  }
  return finish(target, path);
}

bool Moves::centre_offset(const Words& words, char letter, double& mm) {
  mm = 0;
  return !words.has(letter) || state_.values.length(words[letter], mm);
}

// The centre in programmed coordinates. `nothing`: R with an end equal to the start (ARC-4).
bool Moves::read_centre(const Words& words, const motion::PlaneAxes& plane, const Target& target,
                        bool clockwise, Vec2& centre, bool& nothing) {
  const Vec2 from = plane.project(state_.coordinates.program());
  const Vec2 to = plane.project(target.program);
  if (words.has('R')) {
    double radius = 0;
    if (!state_.values.length(words['R'], radius)) return false;
    nothing = from == to;
    if (nothing) return true;
    const auto found =
        geometry::centre_from_radius(from, to, radius, clockwise, state_.parameters.arc_tolerance);
    if (!found) {
      return state_.alarms.raise(Code::arc_radius_tolerance, words['R'].text,
                                 "the chord is " + millimetres(geometry::length(to - from)) +
                                     " mm long, the diameter " +
                                     millimetres(2 * std::fabs(radius)));
    }
    centre = *found;
    return true;
  }
  const motion::Surface* const surface = state_.path.surface();
  if (surface != nullptr && surface->kind == motion::Surface::Kind::cylinder)
    return state_.alarms.raise(Code::cylinder_misuse, "an arc on the cylinder has its radius R");
  if (!words.has(plane.first_offset) && !words.has(plane.second_offset)) {
    if (!words.has_any(kCentreLetters)) return state_.alarms.raise(Code::arc_without_centre);
    return state_.alarms.raise(Code::illegal_plane_axis,
                               "I, J or K belongs to an axis outside of the plane");
  }
  Vec2 offset;
  if (!centre_offset(words, plane.first_offset, offset.u) ||
      !centre_offset(words, plane.second_offset, offset.v)) {
    return false;
  }
  centre = from + offset;
  const double start_radius = geometry::length(offset);
  const double end_radius = geometry::length(to - centre);
  if (std::fabs(start_radius - end_radius) > state_.parameters.arc_tolerance) {
    return state_.alarms.raise(Code::arc_radius_tolerance,
                               "radius " + millimetres(start_radius) + " at the start, " +
                                   millimetres(end_radius) + " at the end");
  }
  return true;
}

// An arc stays a circle when the factors of its plane differ: its ends are scaled each by their
// factor, its radius by the larger one (docs/dialect.md §8.5).
bool Moves::unevenly_scaled_centre(const motion::PlaneAxes& plane, const Target& target,
                                   Vec2 centre, bool clockwise, Vec2& image) {
  state_.assume(Assumed::scaled_arc,
                "an arc with unequal scaling factors is a circle by the larger factor");
  const Transform& transform = state_.coordinates.transform();
  const Vec2 from = plane.project(state_.coordinates.program());
  const Vec2 to = plane.project(target.program);
  const Vec2 image_from = plane.project(state_.coordinates.path());
  const Vec2 image_to = plane.project(state_.coordinates.path_of(target.program));
  const double radius = geometry::length(from - centre) * transform.radius_factor(plane);
  if (from == to) {
    ProgramPoint centre_point = target.program;
    plane.place(centre_point, centre);
    const Vec2 arm = plane.project(state_.coordinates.path_of(centre_point)) - image_from;
    image = image_from + radius * geometry::unit(arm);
    return true;
  }
  const bool long_way = geometry::sweep_rad(from, to, centre, clockwise) > std::numbers::pi;
  const auto found = geometry::centre_from_radius(image_from, image_to, long_way ? -radius : radius,
                                                  clockwise != transform.reverses(plane),
                                                  state_.parameters.arc_tolerance);
  if (!found) {
    return state_.alarms.raise(Code::arc_radius_tolerance,
                               "the scaled end points do not lie on a circle of the scaled radius");
  }
  image = *found;
  return true;
}

bool Moves::arc(const Words& words, bool clockwise, const Target& target) {
  const auto plane = state_.plane();
  if (!plane)
    return state_.alarms.raise(Code::illegal_plane_axis, "the machine lacks an axis of the plane");
  const Transform& transform = state_.coordinates.transform();
  if (transform.rotated() && !transform.rotates(*plane)) {
    return state_.alarms.raise(Code::illegal_transform_plane);
  }
  const auto outside =
      static_cast<unsigned>(target.named & ~(base::only(plane->first) | base::only(plane->second)));
  if (std::popcount(outside) > kMostHelixAxes) return state_.alarms.raise(Code::helix_axes);
  if (words.has('F') && state_.words.feed == 0)
    return state_.alarms.raise(Code::arc_in_rapid, words['F'].text);
  Vec2 centre;
  bool nothing = false;
  if (!has_feed(words) || !read_centre(words, *plane, target, clockwise, centre, nothing))
    return false;
  const PathPoint path = state_.coordinates.path_of(target.program);
  if (!check_limits(path)) return false;
  const PathPoint from = state_.coordinates.path();
  if (nothing)
    return (outside == 0 || state_.path.move(from, motion::Line{on_path(path), feed()})) &&
           finish(target, path);
  const bool image_clockwise = clockwise != transform.reverses(*plane);
  Vec2 image;
  if (transform.scales_evenly(*plane)) {
    ProgramPoint centre_point = target.program;
    plane->place(centre_point, centre);
    image = plane->project(state_.coordinates.path_of(centre_point));
  } else if (!unevenly_scaled_centre(*plane, target, centre, clockwise, image)) {
    return false;
  }
  const ArcShape shape{
      state_.modal.plane(),
      *plane,
      {base::tidy(image.u), base::tidy(image.v)},
      image_clockwise ? motion::Direction::clockwise : motion::Direction::counterclockwise,
      0};
  return state_.path.arc(from, path, shape, feed()) && finish(target, path);
}

// NUM-6: the lead is F; without a decimal point it counts hundredths.
bool Moves::read_lead(const Words& words, double& lead) {
  if (!words.has('F') && state_.words.feed == 0)
    return state_.alarms.raise(Code::feed_zero, "a thread needs its lead F");
  if (state_.words.speed == 0)
    return state_.alarms.raise(Code::speed_zero, "a thread needs a turning spindle");
  lead = state_.words.feed;
  if (words.has('F')) {
    lead = words['F'].value;
    const bool bare =
        words['F'].has(gcode::WordFlag::literal) && !words['F'].has(gcode::WordFlag::point);
    if (bare && !state_.parameters.calculator_point) lead *= state_.modal.inch() ? 0.0001 : 0.01;
    if (state_.modal.inch()) lead = base::tidy(lead * motion::kMillimetresPerInch);
    state_.words.feed = lead;
  }
  lead = base::tidy(lead);
  if (state_.codes.habits().tool_brings_offset && state_.has_surface_speed())
    state_.assume(Assumed::thread_under_css,
                  "a thread under G96 keeps the speed that the spindle has where it begins");
  return true;
}

// G33 and its like; Q is where on the circumference the thread begins, K of G34 how its lead grows.
bool Moves::thread(const Words& words, const Target& target) {
  motion::Thread cut;
  if (!read_lead(words, cut.lead) || !read_start(words, cut)) return false;
  const PathPoint path = state_.coordinates.path_of(target.program);
  cut.to = on_path(path);
  return check_limits(path) && can_follow_spindle(cut) && state_.path.straight(cut) &&
         finish(target, path);
}

bool Moves::read_start(const Words& words, motion::Thread& cut) {
  if (words.has('Q')) {
    double thousandths = 0;
    if (!state_.values.plain(words['Q'], thousandths)) return false;
    cut.angle_deg = base::tidy(thousandths / 1000);
  }
  const bool grows = state_.modal[Group::motion] == Meaning::thread_of_variable_lead;
  return !grows || !words.has('K') || state_.values.length(words['K'], cut.lead_change);
}

// Slower than the spindle asks for it would have another lead.
bool Moves::can_follow_spindle(const motion::Thread& thread) {
  const base::TipPoint from = state_.path.tip();
  if (std::isinf(motion::ThreadWay(thread, from, state_.axes).revolutions()))
    return state_.alarms.raise(Code::thread_lead_negative);
  const double most = motion::highest_rpm(thread, from, state_.axes);
  const double rpm = motion::rpm_at(state_.spindle(), from);
  constexpr double kSame = 1 + 1e-9;
  if (rpm <= most * kSame) {
    if (state_.codes.habits().tool_brings_offset) tell_run_in(thread, from, rpm);
    return true;
  }
  return state_.alarms.raise(Code::spindle_too_fast,
                             "S" + base::rounded_text(rpm, 0) + ", at most S" +
                                 base::rounded_text(std::floor(most * kSame), 0));
}

// Where the part begins is not known: at the zero of the work system, if the thread begins before.
// The axes need δ1 until they follow within a = 2 %: the lag of a servo with 0.033 s.
void Moves::tell_run_in(const motion::Thread& thread, const base::TipPoint& from, double rpm) {
  const auto z = state_.axes.find('Z');
  if (!z) return;
  const double begin = from[*z] - state_.coordinates.origin()[*z];
  const double end = thread.to[*z] - state_.coordinates.origin()[*z];
  if (begin * end >= 0) return;
  const double needed_mm = thread.lead * rpm / 1800 * kForTwoPercent;
  if (std::fabs(begin) >= needed_mm || !state_.assumptions.is_new(Assumed::short_run_in)) return;
  state_.assumptions.add(state_.line, "the thread begins " + millimetres(std::fabs(begin)) +
                                          " mm before Z0; for a lead within 2 % it needs " +
                                          base::rounded_text(needed_mm, 3) + " mm");
}

}  // namespace kerf::control
