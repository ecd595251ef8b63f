#include "control/laser/laser_moves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "geometry/angle.hpp"
#include "geometry/arc.hpp"
#include "geometry/space_arc.hpp"
#include "geometry/tolerance.hpp"
#include "motion/motion_extent.hpp"

namespace kerf::control {
namespace {

using base::Code;
using base::TipPoint;
using geometry::kSamePoint_mm;
using geometry::Vec2;
using geometry::Vec3;

// A chord may be longer than the diameter by this much, which the words of a program round away.
constexpr double kRadiusRounding_mm = 1e-6;
constexpr double kFullCircle_deg = 360;
constexpr double kMostTurns = 60000;

Vec2 flat(const Vec3& point) { return {point.x, point.y}; }

bool same(const Vec3& a, const Vec3& b) { return length(a - b) <= kSamePoint_mm; }

// All points of a smaller circle are the same.
bool is_radius(double radius) { return radius > kSamePoint_mm; }
constexpr const char* kNoRadius = "the radius is above 0.000001 mm";

// As long as a dwell of G-code can be.
bool is_time(double seconds) { return seconds >= 0 && seconds <= 99999.999; }
constexpr const char* kNoTime = "a time is 0 to 99999.999 s";

}  // namespace

LaserMoves::LaserMoves(const motion::AxisSetup& axes, Alarms& alarms, Assumptions& assumptions,
                       Outlet& outlet, Warn warn)
    : axes_(axes),
      alarms_(alarms),
      assumptions_(assumptions),
      outlet_(outlet),
      warn_(std::move(warn)),
      tip_(axes.start) {
  constexpr std::string_view kLetters = "XYZ";
  for (std::size_t i = 0; i < kLetters.size(); ++i) xyz_[i] = axes.find(kLetters[i]);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!xyz_[i]) continue;
    const double rate = axes[*xyz_[i]].rapid_per_min / 60;
    highest_speed_ = highest_speed_ == 0 ? rate : std::min(highest_speed_, rate);
  }
}

void LaserMoves::start(const Settings& settings) {
  settings_ = settings;
  outlet_.reset();
  speed_ = highest_speed_;
  power_ = frequency_hz_ = moved_ = 0;
  beam_ = {};
  power_set_ = speed_set_ = false;
  refresh_position();
}

void LaserMoves::refresh_position() {
  const auto value = [&](std::size_t i) {
    return xyz_[i] ? tip_[*xyz_[i]] - settings_.origin[*xyz_[i]] : 0;
  };
  position_ = {value(0), settings_.invert_y ? -value(1) : value(1), value(2)};
}

bool LaserMoves::raise(Code code, const std::string& detail) { return alarms_.raise(code, detail); }

// Statements

bool LaserMoves::home() {
  const motion::Motion rapid = motion(motion::Rapid{machine_point({}), true});
  if (!admits(tip_, rapid)) return false;
  return set_beam(0) && make(rapid, {}, length(position_));
}

bool LaserMoves::speed(double mm_s) {
  if (!(mm_s > 0)) return raise(Code::basic_domain, "a speed is above 0 mm/s");
  if (mm_s > highest_speed_)
    warn_(Code::basic_speed_clamped, base::number_text(mm_s) + " mm/s, the machine makes " +
                                         base::number_text(base::tidy(highest_speed_)));
  speed_ = std::min(mm_s, highest_speed_);
  speed_set_ = true;
  return true;
}

bool LaserMoves::power(double percent) {
  if (percent < 0 || percent > 100) return raise(Code::basic_domain, "a power is 0 to 100 percent");
  power_set_ = true;
  return set_power(percent);
}

bool LaserMoves::pulse(double on_ms, double off_ms) {
  if (!(on_ms >= 0 && off_ms >= 0))
    return raise(Code::basic_domain, "the times of a pulse are 0 ms or more");
  const double period_ms = on_ms + off_ms;
  if (period_ms == 0) {
    frequency_hz_ = 0;
    return set_power(power_);
  }
  constexpr double kLongest_ms = 1e6;
  if (!(period_ms <= kLongest_ms && period_ms >= 1 / kLongest_ms))
    return raise(Code::basic_domain, "a pulse and its pause last 0.000001 to 1000000 ms");
  frequency_hz_ = base::tidy(1000 / period_ms);
  power_set_ = true;
  return set_power(base::tidy(100 * on_ms / period_ms));
}

// Told where the beam is off; in a cut the next one tells it.
bool LaserMoves::set_power(double percent) {
  power_ = percent;
  return beam_.percent > 0 ||
         outlet_.let_out(motion(motion::Power{percent, false, false, frequency_hz_}), tip_);
}

bool LaserMoves::air(double on) {
  using Flow = motion::Coolant::State;
  if (on != 0 && on != 1) return raise(Code::basic_domain, "AIR is 0, off, or 1, on");
  return outlet_.let_out(motion(motion::Coolant{on == 1 ? Flow::mist : Flow::off}), tip_);
}

bool LaserMoves::move(std::span<const double> xy_or_xyz) {
  const Vec3 to = target(xy_or_xyz);
  const motion::Motion rapid = motion(motion::Rapid{machine_point(to), true});
  if (!admits(tip_, rapid)) return false;
  return set_beam(0) && make(rapid, to, length(to - position_));
}

bool LaserMoves::line(std::span<const double> xy_or_xyz) {
  const Vec3 to = target(xy_or_xyz);
  const motion::Motion line = motion(motion::Line{machine_point(to), feed()});
  return cut(position_, line, to, length(to - position_));
}

bool LaserMoves::circle(std::span<const double> a) {
  const double radius = a.back();
  if (!is_radius(radius)) return raise(Code::basic_arc, kNoRadius);
  const double z = a.size() == 4 ? a[2] : position_.z;
  const Vec3 right{a[0] + radius, a[1], z};
  const Vec3 start = same(right, position_) ? position_ : right;
  const FlatArc arc{.to = start, .centre = {a[0], a[1]}, .length = 2 * std::numbers::pi * radius};
  return cut(start, flat_motion(arc), start, arc.length);
}

bool LaserMoves::arc(std::span<const double> arguments) {
  constexpr std::size_t kCentreRadiusEnd = 4;
  constexpr std::size_t kCentreRadiusAngles = 5;
  if (arguments.size() == kCentreRadiusEnd) return arc_by_radius(arguments);
  if (arguments.size() == kCentreRadiusAngles) return arc_by_angles(arguments);
  return arc_through(arguments);
}

// Through P1 to P2; in a plane of constant Z it is an arc of that plane.
bool LaserMoves::arc_through(std::span<const double> a) {
  const Vec3 via{a[0], a[1], a[2]};
  const Vec3 to{a[3], a[4], a[5]};
  const auto circle = geometry::SpaceArc::through(position_, via, to);
  if (!circle) {
    return raise(Code::basic_arc, circle.error() == geometry::NoArc::coincident
                                      ? "two of its points are the same"
                                      : "its points lie on a line");
  }
  if (via.z == position_.z && to.z == position_.z) {
    const FlatArc arc{.to = to,
                      .centre = flat(circle->centre()),
                      .clockwise = circle->e3().z < 0,
                      .length = circle->length()};
    return cut(position_, flat_motion(arc), to, arc.length);
  }
  const motion::SpaceArc arc{.to = machine_point(to), .via = machine_point(via), .feed = feed()};
  return cut(position_, motion(arc), to, circle->length());
}

// What it sweeps says how many circles it makes: of its ends, rounded, one would not know.
bool LaserMoves::arc_by_angles(std::span<const double> a) {
  const Vec2 centre{a[0], a[1]};
  const double radius = a[2];
  const double sweep = a[4] - a[3];
  if (!is_radius(radius)) return raise(Code::basic_arc, kNoRadius);
  if (sweep == 0) return raise(Code::basic_arc, "it sweeps 0 degrees");
  const double circles = std::fabs(sweep) / kFullCircle_deg;
  if (circles > kMostTurns) return raise(Code::basic_domain, "an arc makes at most 60000 turns");
  const auto at = [&](double angle_deg) {
    const geometry::SineCosine turn = geometry::sine_cosine_deg(angle_deg);
    return Vec3{centre.u + radius * turn.cosine, centre.v + radius * turn.sine, position_.z};
  };
  const Vec3 first = at(a[3]);
  const Vec3 last = at(a[4]);
  const Vec3 start = same(first, position_) ? position_ : first;
  const bool closed = same(first, last);
  FlatArc arc{.to = closed ? start : last, .centre = centre, .clockwise = sweep < 0};
  arc.length = radius * geometry::radians(std::fabs(sweep));
  if (closed && circles < 0.5)
    return cut(start, motion(motion::Line{machine_point(last), feed()}), last, arc.length);
  const double turns = closed ? std::round(circles) - 1 : std::floor(circles);
  arc.turns = static_cast<std::uint16_t>(turns);
  return cut(start, flat_motion(arc), arc.to, arc.length);
}

bool LaserMoves::arc_by_radius(std::span<const double> a) {
  const Vec2 from = flat(position_);
  const Vec3 to{a[0], a[1], position_.z};
  if (a[3] == 0)
    return raise(Code::basic_domain,
                 "the direction is above 0, counterclockwise, or below 0, clockwise");
  if (a[2] == 0) return raise(Code::basic_arc, "the radius is 0");
  if (same(to, position_)) return raise(Code::basic_arc, "it ends where it begins");
  const bool clockwise = a[3] < 0;
  const auto centre =
      geometry::centre_from_radius(from, flat(to), a[2], clockwise, kRadiusRounding_mm / 2);
  if (!centre) return raise(Code::basic_arc, "the radius is less than half the way");
  // So flat that no point of it is another one than that of its chord.
  const double chord = length(to - position_);
  if (a[2] > 0 && chord * chord / (8 * a[2]) < kSamePoint_mm)
    return cut(position_, motion(motion::Line{machine_point(to), feed()}), to, chord);
  FlatArc arc{.to = to, .centre = *centre, .clockwise = clockwise};
  arc.length = geometry::arc_length(from, flat(to), *centre, clockwise, 0, 0);
  return cut(position_, flat_motion(arc), to, arc.length);
}

bool LaserMoves::rest(double seconds) {
  return seconds == 0 || outlet_.let_out(motion(motion::Dwell{seconds}), tip_);
}

bool LaserMoves::wait(double seconds) {
  if (!is_time(seconds)) return raise(Code::basic_domain, kNoTime);
  return set_beam(0) && rest(seconds);
}

bool LaserMoves::burn(double seconds) {
  if (!is_time(seconds)) return raise(Code::basic_domain, kNoTime);
  if (!power_set_) warn_(Code::basic_no_power, {});
  return seconds == 0 || (set_beam(power_) && rest(seconds) && set_beam(0));
}

bool LaserMoves::end() { return set_beam(0) && outlet_.let_out(motion(motion::End{}), tip_); }

// Also behind a move that was refused, when nothing else is handed out any more.
void LaserMoves::beam_off() {
  outlet_.reset();
  static_cast<void>(set_beam(0));
}

// Points and motions

Vec3 LaserMoves::target(std::span<const double> xy_or_xyz) const {
  return {xy_or_xyz[0], xy_or_xyz[1], xy_or_xyz.size() > 2 ? xy_or_xyz[2] : position_.z};
}

TipPoint LaserMoves::machine_point(const Vec3& program) const {
  TipPoint point = tip_;
  const std::array<double, 3> values = {program.x, settings_.invert_y ? -program.y : program.y,
                                        program.z};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (xyz_[i]) point[*xyz_[i]] = base::tidy(values[i] + settings_.origin[*xyz_[i]]);
  }
  return point;
}

Vec2 LaserMoves::machine_centre(Vec2 program) const {
  const double y = settings_.invert_y ? -program.v : program.v;
  return {program.u + (xyz_[0] ? settings_.origin[*xyz_[0]] : 0),
          y + (xyz_[1] ? settings_.origin[*xyz_[1]] : 0)};
}

motion::Motion LaserMoves::motion(const motion::Motion::Action& action) const {
  return {.block = statement_, .action = action};
}

motion::Motion LaserMoves::flat_motion(const FlatArc& arc) const {
  const Vec2 centre = machine_centre(arc.centre);
  return motion(motion::Arc{.to = machine_point(arc.to),
                            .center = {base::tidy(centre.u), base::tidy(centre.v)},
                            .feed = feed(),
                            .turns = arc.turns,
                            .plane = motion::Plane::xy,
                            .direction = arc.clockwise != settings_.invert_y
                                             ? motion::Direction::clockwise
                                             : motion::Direction::counterclockwise});
}

// Every point of the motion lies within the travel of its axes, and a linkage can follow.
bool LaserMoves::admits(const TipPoint& from, const motion::Motion& motion) {
  const motion::MotionExtent extent = motion::extent_of(axes_, from, motion);
  for (const auto& axis : xyz_) {
    if (!axis) continue;
    const motion::AxisConfig& config = axes_[*axis];
    if (!(config.travel_min < config.travel_max)) continue;
    const bool low = extent.low[*axis] < config.travel_min - kSamePoint_mm;
    if (!low && extent.high[*axis] <= config.travel_max + kSamePoint_mm) continue;
    return raise(Code::basic_travel,
                 std::string(1, config.letter) + " would be " +
                     base::number_text(low ? extent.low[*axis] : extent.high[*axis]) +
                     ", the machine goes from " + base::number_text(config.travel_min) + " to " +
                     base::number_text(config.travel_max));
  }
  return true;
}

bool LaserMoves::set_beam(double percent) {
  motion::Power beam{percent};
  beam.frequency_hz = percent > 0 ? frequency_hz_ : beam_.frequency_hz;
  if (beam == beam_) return true;
  beam_ = beam;
  return outlet_.let_out(motion(beam), tip_);
}

void LaserMoves::warn_of_cut() {
  if (!power_set_) warn_(Code::basic_no_power, {});
  if (speed_set_ || !assumptions_.is_new(Assumed::no_speed)) return;
  assumptions_.add(statement_.line, "no SPEED: cuts at the machine's " +
                                        base::number_text(base::tidy(highest_speed_)) + " mm/s");
}

bool LaserMoves::make(const motion::Motion& motion, const Vec3& to, double length) {
  const bool nowhere =
      *motion::target_of(motion) == tip_ && !std::holds_alternative<motion::Arc>(motion.action);
  if (!nowhere && !outlet_.let_out(motion, tip_)) return false;
  tip_ = *motion::target_of(motion);
  position_ = to;
  moved_ = length;
  return true;
}

bool LaserMoves::cut(const Vec3& start, const motion::Motion& motion, const Vec3& to,
                     double length) {
  const motion::Motion way = this->motion(motion::Rapid{machine_point(start), true});
  const TipPoint begin = *motion::target_of(way);
  if (begin != tip_ && !admits(tip_, way)) return false;
  if (!admits(begin, motion)) return false;
  warn_of_cut();
  if (begin != tip_ && !(set_beam(0) && make(way, start, geometry::length(start - position_))))
    return false;
  if (*motion::target_of(motion) == tip_ && length == 0) {
    moved_ = 0;
    position_ = to;
    return true;
  }
  return set_beam(power_) && make(motion, to, length);
}

}  // namespace kerf::control
