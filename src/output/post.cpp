#include "output/post.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/decimal.hpp"
#include "control/plane_axes.hpp"
#include "control/space_arc_path.hpp"
#include "geometry/arc.hpp"
#include "math/math.hpp"
#include "output/internal/feed_per_minute.hpp"

namespace kerf::output {
namespace {

using namespace control;

constexpr double kStep = 1e4;             // coordinates are written to 0.0001
constexpr double kMostRadius_mm = 99999;  // controls keep I, J, K to so many digits
constexpr std::size_t kLongestComment = 60;

double rounded(double value) { return std::round(value * kStep) / kStep + 0.0; }

// Without an exponent, which G-code does not know.
std::string digits(double value) {
  std::array<char, 400> text{};  // more than the longest double has
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

// As a comment may hold it: the capitals, digits and marks that every controller reads.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, kLongestComment)) {
    const auto code = static_cast<unsigned char>(c);
    const bool reads = code >= ' ' && code <= '~' && c != '(' && c != ')';
    out += reads ? static_cast<char>(std::toupper(code)) : '?';
  }
  return out;
}

std::string beam_word(const machine::LaserSettings& laser, const Power& power) {
  const bool dynamic = laser.post_beam == machine::LaserSettings::Beam::dynamic;
  return dynamic || power.follows_speed ? "M4" : "M3";
}

}  // namespace

Post::Post(const AxisSetup& axes, base::OutputFile& file, const machine::LaserSettings& laser)
    : axes_(axes), file_(file), at_(axes.start), laser_(laser) {
  file_.write("(KERF: TOOL CENTRE PATH IN MACHINE COORDINATES)\n");
  if (laser_.fitted())
    file_.write("(LASER: FULL POWER IS S" + base::number_text(laser_.s_of_full_power) + ")\n");
  file_.write("G21 G90 G94 G17\n");
}

// What the program says there and plain G-code does not.
void Post::comment(const std::string& text) {
  block("(LINE " + std::to_string(source_line_) + ": " + plain(text) + ")");
  if (only_comments_++ == 0) first_comment_line_ = source_line_;
}

void Post::block(const std::string& text) {
  line_ = text;
  end_block();
}

void Post::word(char letter, double value) {
  if (!line_.empty()) line_ += ' ';
  line_ += letter;
  line_ += digits(value);
}

// A control that counts X10 in thousandths takes X10. as 10 mm.
void Post::coordinate(char letter, double value) {
  word(letter, value);
  if (line_.find('.', line_.rfind(letter)) == std::string::npos) line_ += '.';
}

void Post::end_block() {
  if (!line_.empty()) {
    line_ += '\n';
    file_.write(line_);
  }
  line_.clear();
}

// The first move names every axis that does not stand at 0 at power-on: another controller's does.
void Post::move(const char* code, const base::AxisVector& to) {
  if (modal_ != code) {
    if (!line_.empty()) line_ += ' ';
    line_ += code;
  }
  modal_ = code;
  cuts_ = beam_on_ && modal_ != "G0";
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const double value = rounded(to.values[i]);
    const bool unknown = !moved_ && axes_.start.values[i] != 0;
    if (unknown || value != rounded(at_.values[i])) coordinate(axes_.axes[i].letter, value);
  }
  at_ = to;
  moved_ = true;
}

void Post::feed(double per_minute) {
  if (per_minute == feed_) return;
  feed_ = per_minute;
  word('F', per_minute);
}

void Post::select_plane(Plane plane) {
  if (plane == plane_) return;
  plane_ = plane;
  line_ = plane == Plane::xy ? "G17" : plane == Plane::zx ? "G18" : "G19";
  end_block();
}

bool Post::rounded_equal(const base::AxisVector& a, const base::AxisVector& b) const {
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    if (rounded(a.values[i]) != rounded(b.values[i])) return false;
  }
  return true;
}

// Nothing where the output's digits show no way.
void Post::line(const base::AxisVector& to, double per_minute) {
  if (rounded_equal(at_, to)) {
    at_ = to;
    return;
  }
  move("G1", to);
  feed(per_minute);
  end_block();
}

void Post::straight(const base::AxisVector& to, const Feed& rate) {
  double squares = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i)
    squares += math::pow(to.values[i] - at_.values[i], 2);
  line(to, rounded(feed_per_minute(rate, std::sqrt(squares), speed_rpm_)));
}

// G96 stays what it is: its speed follows from where the tool stands.
void Post::act(const Spindle& spindle) {
  const bool turns = spindle.turning == Spindle::Turning::clockwise ||
                     spindle.turning == Spindle::Turning::counterclockwise;
  const bool css = turns && spindle.mode == Spindle::Mode::constant_surface_speed;
  speed_rpm_ = css ? spindle.max_rpm : spindle.speed;
  turning_.clear();
  if (!turns) {
    block("M5");
    if (spindle.turning == Spindle::Turning::oriented) comment("M19");
    return;
  }
  if (css && spindle.max_rpm > 0) {
    line_ = "G92";
    word('S', rounded(spindle.max_rpm));
    end_block();
  }
  if (css != css_) line_ = css ? "G96" : "G97";
  css_ = css;
  if (!line_.empty()) line_ += ' ';
  turning_ = spindle.turning == Spindle::Turning::clockwise ? "M3 S" : "M4 S";
  turning_ += digits(rounded(spindle.speed));
  line_ += turning_;
  end_block();
}

// Each rises by its share of the way along the other axes, and closes in the plane: what the radius
// changes by, which is within the control's tolerance, is left to the rest of the arc.
void Post::full_circles(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  const double rest_rad =
      geometry::sweep_rad(plane.project(at_), plane.project(arc.to), {arc.center[0], arc.center[1]},
                          arc.direction == Direction::clockwise);
  const double turns = arc.turns + rest_rad / (2 * std::numbers::pi);
  const base::AxisVector from = at_;
  Arc circle = arc;
  for (unsigned turn = 1; turn <= arc.turns; ++turn) {
    circle.to = from;
    for (std::size_t i = 0; i < axes_.count(); ++i) {
      const base::Axis axis{static_cast<std::uint8_t>(i)};
      if (!plane.contains(axis)) circle.to[axis] += (arc.to[axis] - from[axis]) * turn / turns;
    }
    sweep(circle, plane, per_minute);
  }
}

// At most a turn; to where it starts it is a whole one.
void Post::sweep(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  const geometry::Vec2 from = plane.project(at_);
  select_plane(arc.plane);
  const bool stays = rounded_equal(at_, arc.to);
  modal_.clear();
  move(arc.direction == Direction::clockwise ? "G2" : "G3", arc.to);
  if (stays) {
    coordinate(axes_[plane.first].letter, rounded(arc.to[plane.first]));
    coordinate(axes_[plane.second].letter, rounded(arc.to[plane.second]));
  }
  coordinate(plane.first_offset, rounded(arc.center[0] - rounded(from.u)));
  coordinate(plane.second_offset, rounded(arc.center[1] - rounded(from.v)));
  feed(per_minute);
  end_block();
}

void Post::act(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, axes_);
  if (!plane) return;
  const geometry::Vec2 from = plane->project(at_);
  const geometry::Vec2 to = plane->project(arc.to);
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  const bool clockwise = arc.direction == Direction::clockwise;
  const double length = geometry::arc_length(from, to, centre, clockwise, arc.turns, 0);
  const double per_minute = rounded(feed_per_minute(arc.feed, length, speed_rpm_));
  if (const auto rise = flat_rise(arc, *plane)) return flat_arc(arc, *plane, *rise);
  const bool closed = rounded(from.u) == rounded(to.u) && rounded(from.v) == rounded(to.v);
  const bool short_way = geometry::sweep_rad(from, to, centre, clockwise) < std::numbers::pi;
  full_circles(arc, *plane, per_minute);
  // An arc to its own start is a full circle: one that is shorter than a digit must not look so.
  if (closed && short_way) {
    line(arc.to, per_minute);
  } else {
    sweep(arc, *plane, per_minute);
  }
}

// How high an arc rises above its chord, where its centre is too far away to be written.
std::optional<double> Post::flat_rise(const Arc& arc, const PlaneAxes& plane) const {
  const geometry::Vec2 from = plane.project(at_);
  const geometry::Vec2 to = plane.project(arc.to);
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  const double radius = length(centre - from);
  const double half = length(to - from) / 2;
  if (radius <= kMostRadius_mm || half == 0 || arc.turns > 0) return std::nullopt;
  const bool clockwise = arc.direction == Direction::clockwise;
  if (geometry::sweep_rad(from, to, centre, clockwise) >= std::numbers::pi) return std::nullopt;
  return half * half / (radius + std::sqrt((radius - half) * (radius + half)));
}

// Chords, of the arc through the point half way.
void Post::flat_arc(const Arc& arc, const PlaneAxes& plane, double rise) {
  if (rise < kChordTolerance_mm) return straight(arc.to, arc.feed);
  const geometry::Vec2 way = plane.project(arc.to) - plane.project(at_);
  const double side = (arc.direction == Direction::clockwise ? -rise : rise) / length(way);
  SpaceArc flat{.to = arc.to, .via = at_, .feed = arc.feed};
  for (std::size_t i = 0; i < axes_.count(); ++i)
    flat.via.values[i] += (arc.to.values[i] - at_.values[i]) / 2;
  flat.via[plane.first] += side * way.v;
  flat.via[plane.second] -= side * way.u;
  act(flat);
}

// Within half a digit of the output the arc lies in the plane, and nothing else moves.
std::optional<Arc> Post::plane_arc(const SpaceArc& arc, const geometry::SpaceArc& circle,
                                   Plane plane) const {
  const auto axes = plane_axes(plane, axes_);
  if (!axes || circle.radius() > kMostRadius_mm) return std::nullopt;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    if (axes->contains(base::Axis{static_cast<std::uint8_t>(i)})) continue;
    const double stays = rounded(at_.values[i]);
    const bool leaves = rounded(arc.via.values[i]) != stays || rounded(arc.to.values[i]) != stays ||
                        (arc.full_circle && rounded(arc.second_via.values[i]) != stays);
    if (leaves) return std::nullopt;
  }
  const geometry::Vec3& e3 = circle.e3();
  const geometry::Vec3& centre = circle.centre();
  const double upright = plane == Plane::xy ? e3.z : plane == Plane::zx ? e3.y : e3.x;
  const double tilt = std::sqrt(std::max(0.0, (1 - upright) * (1 + upright)));
  if (2 * circle.radius() * tilt > 0.5 / kStep) return std::nullopt;
  const std::array<double, 2> in_plane = plane == Plane::xy   ? std::array{centre.x, centre.y}
                                         : plane == Plane::zx ? std::array{centre.z, centre.x}
                                                              : std::array{centre.y, centre.z};
  return Arc{.to = arc.to,
             .center = in_plane,
             .feed = arc.feed,
             .plane = plane,
             .direction = upright > 0 ? Direction::counterclockwise : Direction::clockwise};
}

void Post::act(const SpaceArc& arc) {
  const SpaceArcPath path(axes_, at_, arc);
  for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz}) {
    if (const auto flat = plane_arc(arc, path.circle(), plane)) return act(*flat);
  }
  const double most_rad = geometry::chord_angle_rad(path.circle().radius(), kChordTolerance_mm);
  const double per_minute = rounded(feed_per_minute(arc.feed, path.circle().length(), speed_rpm_));
  path.chords(most_rad, [&](const base::AxisVector& to) { line(to, per_minute); });
}

void Post::act(const Rapid& rapid) {
  move("G0", rapid.to);
  end_block();
}

void Post::act(const Line& line) { straight(line.to, line.feed); }

void Post::act(const Probe& probe) {
  comment("PROBING MOVE");
  straight(probe.to, probe.feed);
}

void Post::act(const Thread& thread) {
  comment("THREAD OF LEAD " + base::number_text(rounded(thread.lead)));
  straight(thread.to, {thread.lead, FeedMode::per_revolution});
}

// Its point says that P counts seconds: where it counts milliseconds, it may have none. A beam that
// was turned on behind a rapid burns from G1 on.
void Post::act(const Dwell& dwell) {
  if (beam_on_ && laser_.fitted() && !cuts_) {
    line_ = modal_ = "G1";
    if (feed_ < 0) feed(1);  // many a control takes no G1 before any F
    end_block();
  }
  cuts_ = beam_on_;
  line_ = "G4";
  coordinate('P', rounded(dwell.seconds));
  end_block();
}

// M6 stops the spindle on many a control, and the program goes on with it.
void Post::act(const ToolChange& change) {
  block("T" + std::to_string(change.tool) + " M6");
  block(turning_);
}

void Post::act(const Coolant& coolant) {
  switch (coolant.state) {
    case Coolant::State::off: return block("M9");
    case Coolant::State::mist: return block("M7");
    case Coolant::State::flood: return block("M8");
  }
}

// A beam that is only set takes its power as S alone, once it is off.
void Post::act(const Power& power) {
  const double percent = rounded(power.beam_percent());
  if (!laser_.fitted()) {
    const std::string beam = percent > 0 ? base::number_text(percent) + " PERCENT" : "OFF";
    if (power.on || beam_on_) comment("LASER " + beam);
    beam_on_ = percent > 0;
    return;
  }
  const double s = rounded(power.percent / 100 * laser_.s_of_full_power);
  if (percent == 0 && beam_on_) block("M5");
  beam_on_ = percent > 0;
  cuts_ = cuts_ && beam_on_;
  if (beam_on_) line_ = beam_word(laser_, power);
  if (beam_on_ || (!power.on && s != s_)) word('S', s_ = s);
  turning_ = beam_on_ ? line_ : std::string();
  end_block();
}

void Post::act(const AuxiliaryCode& code) { comment("M" + std::to_string(code.code)); }
void Post::act(const Stop& stop) { block(stop.optional ? "M1" : "M0"); }
void Post::act(const Message& message) { comment("MESSAGE " + std::string(message.text.view())); }

void Post::act(const End& /*end*/) { finish(); }

void Post::take(const Motion& motion) {
  source_line_ = motion.line;
  tell_override(motion);
  std::visit([this](const auto& action) { act(action); }, motion.action);
}

// Of tapping, which goes with the spindle, and of #3004.
void Post::tell_override(const Motion& motion) {
  if (target_of(motion) == nullptr) return;
  const bool fixed = motion.fixed_override && !std::holds_alternative<Rapid>(motion.action) &&
                     !std::holds_alternative<Thread>(motion.action) &&
                     !std::holds_alternative<Probe>(motion.action);
  if (fixed && !fixed_) comment("FEED WITHOUT OVERRIDE");
  fixed_ = fixed;
}

void Post::finish() {
  if (ended_) return;
  if (beam_on_ && laser_.fitted()) block("M5");
  block("M30");
  ended_ = true;
}

std::string Post::remark() const {
  if (only_comments_ == 0) return {};
  return "  --post: what plain G-code cannot say is in " + std::to_string(only_comments_) +
         (only_comments_ == 1 ? " comment" : " comments") + ", the first one of line " +
         std::to_string(first_comment_line_) + "\n";
}

}  // namespace kerf::output
