#include "output/post.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "control/plane_axes.hpp"
#include "control/space_arc_path.hpp"
#include "geometry/arc.hpp"
#include "output/internal/feed_per_minute.hpp"

namespace kerf::output {
namespace {

using namespace control;

constexpr double kStep = 1e4;             // coordinates are written to 0.0001
constexpr double kMostRadius_mm = 99999;  // controls keep I, J, K to so many digits

double rounded(double value) { return std::round(value * kStep) / kStep + 0.0; }

}  // namespace

Post::Post(const AxisSetup& axes, base::OutputFile& file)
    : axes_(axes), file_(file), at_(axes.start) {
  file_.write("(KERF: TOOL CENTRE PATH IN MACHINE COORDINATES)\nG21 G90 G94 G17\n");
}

void Post::word(char letter, double value) {
  if (!line_.empty()) line_ += ' ';
  line_ += letter;
  base::append_number(line_, value);
}

void Post::end_block() {
  if (!line_.empty()) {
    line_ += '\n';
    file_.write(line_);
  }
  line_.clear();
}

void Post::move(const char* code, const base::AxisVector& to) {
  if (modal_ != code) {
    if (!line_.empty()) line_ += ' ';
    line_ += code;
  }
  modal_ = code;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const double value = rounded(to.values[i]);
    if (value != rounded(at_.values[i])) word(axes_.axes[i].letter, value);
  }
  at_ = to;
}

void Post::feed(const Feed& feed, double length_mm) {
  const double per_minute = rounded(feed_per_minute(feed, length_mm, speed_rpm_));
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
void Post::line(const base::AxisVector& to, const Feed& rate, double length_mm) {
  if (rounded_equal(at_, to)) {
    at_ = to;
    return;
  }
  move("G1", to);
  feed(rate, length_mm);
  end_block();
}

// G96 stays what it is: its speed follows from where the tool stands.
void Post::spindle(const Spindle& spindle) {
  const bool turns = spindle.turning == Spindle::Turning::clockwise ||
                     spindle.turning == Spindle::Turning::counterclockwise;
  const bool css = turns && spindle.mode == Spindle::Mode::constant_surface_speed;
  speed_rpm_ = css ? spindle.max_rpm : spindle.speed;
  if (!turns) {
    line_ = "M5";
    end_block();
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
  line_ += spindle.turning == Spindle::Turning::clockwise ? "M3" : "M4";
  word('S', rounded(spindle.speed));
  end_block();
}

void Post::arc(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, axes_);
  if (!plane) return;
  const geometry::Vec2 from = plane->project(at_);
  const geometry::Vec2 to = plane->project(arc.to);
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  const bool clockwise = arc.direction == Direction::clockwise;
  const double length = geometry::arc_length(from, to, centre, clockwise, arc.turns, 0);
  const bool closed = rounded(from.u) == rounded(to.u) && rounded(from.v) == rounded(to.v);
  const bool short_way = geometry::sweep_rad(from, to, centre, clockwise) < std::numbers::pi;
  // An arc to its own start is a full circle: one that is shorter than a digit must not look so.
  if (closed && short_way && arc.turns == 0) {
    line(arc.to, arc.feed, length);
    return;
  }
  select_plane(arc.plane);
  const bool stays = rounded_equal(at_, arc.to);
  modal_.clear();
  move(clockwise ? "G2" : "G3", arc.to);
  if (stays) {
    word(axes_[plane->first].letter, rounded(arc.to[plane->first]));
    word(axes_[plane->second].letter, rounded(arc.to[plane->second]));
  }
  word(plane->first_offset, rounded(centre.u - from.u));
  word(plane->second_offset, rounded(centre.v - from.v));
  feed(arc.feed, length);
  end_block();
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

void Post::space_arc(const SpaceArc& arc) {
  const SpaceArcPath path(axes_, at_, arc);
  for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz}) {
    if (const auto flat = plane_arc(arc, path.circle(), plane)) return this->arc(*flat);
  }
  const double most_rad = geometry::chord_angle_rad(path.circle().radius(), kChordTolerance_mm);
  const double length = path.circle().length();
  path.chords(most_rad, [&](const base::AxisVector& to) { line(to, arc.feed, length); });
}

void Post::take(const Motion& motion) { write(motion); }

void Post::write(const Motion& motion) {
  const auto length_to = [&](const base::AxisVector& to) {
    double sum = 0;
    for (std::size_t i = 0; i < axes_.count(); ++i)
      sum += std::pow(to.values[i] - at_.values[i], 2);
    return std::sqrt(sum);
  };
  const auto straight = [&](const base::AxisVector& to, const Feed& rate) {
    line(to, rate, length_to(to));
  };
  const auto code = [&](const std::string& text) {
    line_ = text;
    end_block();
  };
  if (const auto* const a = std::get_if<Rapid>(&motion.action)) {
    move("G0", a->to);
    end_block();
  } else if (const auto* const a1 = std::get_if<Line>(&motion.action)) {
    straight(a1->to, a1->feed);
  } else if (const auto* const a2 = std::get_if<Arc>(&motion.action)) {
    arc(*a2);
  } else if (const auto* const space = std::get_if<SpaceArc>(&motion.action)) {
    space_arc(*space);
  } else if (const auto* const a3 = std::get_if<Probe>(&motion.action)) {
    straight(a3->to, a3->feed);
  } else if (const auto* const a4 = std::get_if<Thread>(&motion.action)) {
    straight(a4->to, {a4->lead, FeedMode::per_revolution});
  } else if (const auto* const a5 = std::get_if<Dwell>(&motion.action)) {
    code("G4 P" + base::number_text(rounded(a5->seconds)));
  } else if (const auto* const a6 = std::get_if<ToolChange>(&motion.action)) {
    code("T" + std::to_string(a6->tool) + " M6");
  } else if (const auto* const a7 = std::get_if<Spindle>(&motion.action)) {
    spindle(*a7);
  } else if (const auto* const a8 = std::get_if<Coolant>(&motion.action)) {
    code(a8->state == Coolant::State::off ? "M9" : a8->state == Coolant::State::mist ? "M7" : "M8");
  } else if (const auto* const power = std::get_if<Power>(&motion.action)) {
    const double percent = rounded(power->beam_percent());
    code(percent > 0 ? "(LASER " + base::number_text(percent) + " PERCENT)" : "(LASER OFF)");
  } else if (std::holds_alternative<Stop>(motion.action)) {
    code("M0");
  } else if (std::holds_alternative<End>(motion.action)) {
    ended_ = true;
    code("M30");
  }
}

void Post::finish() {
  if (!ended_) file_.write("M30\n");
  ended_ = true;
}

}  // namespace kerf::output
