#include "output/programs/taught_program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/decimal.hpp"
#include "geometry/arc.hpp"
#include "lang/teach/record_parser.hpp"
#include "lang/teach/record_writer.hpp"
#include "lang/teach/sequence.hpp"
#include "math/math.hpp"
#include "motion/feed.hpp"
#include "motion/plane_axes.hpp"
#include "motion/surface_path.hpp"

namespace kerf::output {
namespace {

using namespace motion;
using base::Axis;
using base::number_text;
using base::TipPoint;
using geometry::SpaceArc;
using geometry::Vec2;
using geometry::Vec3;

constexpr std::string_view kLetters = "XYZAC";
constexpr double kFullTurn_rad = 2 * std::numbers::pi;
constexpr int kLooks = 16;  // at a way, to see whether an arc in space leaves it

// How far a point is from a circle in space.
double off_circle(const geometry::SpaceArc& circle, Vec3 point) {
  const Vec3 arm = point - circle.centre();
  const double along_normal = dot(arm, circle.e3());
  const double radial = length(arm - along_normal * circle.e3()) - circle.radius();
  return math::hypot(along_normal, radial);
}

}  // namespace

TaughtProgram::TaughtProgram(const AxisSetup& axes, const Head& head, DriveFault fault,
                             base::OutputFile& file)
    : axes_(axes), fault_(std::move(fault)), file_(file), at_(axes_.start) {
  write(teach::Version{});
  comment(" tool centre path in machine coordinates");
  write(teach::Units{});
  write(teach::Period{head.period_ms});
  if (head.radii) write(*head.radii);
}

bool TaughtProgram::can_say(const AxisSetup& axes) {
  return std::all_of(axes.axes.begin(), axes.axes.end(), [](const AxisConfig& axis) {
    return kLetters.find(axis.letter) != std::string_view::npos;
  });
}

teach::Pose TaughtProgram::pose(const TipPoint& at) const {
  const auto value = [&](char letter) {
    const auto axis = axes_.find(letter);
    return axis ? at[*axis] : 0;
  };
  return {value('X'), value('Y'), value('Z'), value('A'), value('C')};
}

void TaughtProgram::write(const teach::Record& record) {
  line_.clear();
  teach::append_line(line_, &record, nullptr);
  file_.write(line_);
}

void TaughtProgram::comment(const std::string& text) {
  line_.clear();
  const std::string_view view = text;
  teach::append_line(line_, nullptr, &view);
  file_.write(line_);
}

// mm; degrees where only rotary axes move.
double TaughtProgram::length_to(const TipPoint& to) const {
  const teach::Pose a = pose(at_);
  const teach::Pose b = pose(to);
  const double linear = length(b.focus() - a.focus());
  return linear > 0 ? linear : math::hypot(b.a_deg - a.a_deg, b.c_deg - a.c_deg);
}

// False: it was told as a fault.
bool TaughtProgram::feed(const Feed& feed, double length_mm) {
  const double per_minute =
      std::min(motion::feed_per_minute(feed, length_mm, speed_rpm_), teach::kMostFeed);
  if (!(per_minute > 0)) {
    fault_(base::make_error(base::Code::teach_range, {},
                            "a taught cut needs its feed in mm/min, which is not known"),
           {.block = motion_->block});
    return false;
  }
  if (per_minute != feed_) write(teach::Feed{per_minute});
  feed_ = per_minute;
  return true;
}

// Every path begins with a point.
void TaughtProgram::begin_path() {
  if (!begun_) write(teach::Point{pose(at_), {}});
  begun_ = true;
}

void TaughtProgram::cut(const TipPoint& to, const Feed& rate, double length_mm) {
  begin_path();
  if (feed(rate, length_mm)) write(teach::Line{pose(to)});
  at_ = to;
}

void TaughtProgram::act(const Rapid& rapid) {
  write(teach::Point{pose(rapid.to), {}});
  begun_ = true;
  at_ = rapid.to;
}

void TaughtProgram::act(const Line& line) { cut(line.to, line.feed, length_to(line.to)); }
void TaughtProgram::act(const Probe& probe) { cut(probe.to, probe.feed, length_to(probe.to)); }
void TaughtProgram::act(const Thread& thread) {
  cut(thread.to, {thread.lead, FeedMode::per_revolution}, length_to(thread.to));
}

// An arc in space through the middle of a stretch of the way, if it leaves that by little enough.
std::optional<teach::Arc> TaughtProgram::arc_over(const RoundWay& way, double begin,
                                                  double end) const {
  const teach::Arc arc{pose(way.at((begin + end) / 2)), pose(way.at(end))};
  const auto circle =
      SpaceArc::through(pose(way.at(begin)).focus(), arc.via.focus(), arc.to.focus());
  if (!circle) return std::nullopt;
  for (int i = 1; i < kLooks; ++i) {
    const double share = begin + (end - begin) * i / kLooks;
    if (off_circle(*circle, pose(way.at(share)).focus()) > kTolerance_mm) return std::nullopt;
  }
  return arc;
}

// `count` equal arcs in place of the way. False: they would leave it; nothing is written.
bool TaughtProgram::arcs(const RoundWay& way, double count) {
  const auto piece = [&](double n) { return arc_over(way, n / count, (n + 1) / count); };
  for (double n = 0; n < count; ++n) {
    if (!piece(n)) return false;
  }
  for (double n = 0; n < count; ++n) write(*piece(n));
  return true;
}

// Once or more times round to where the way begins, and nothing else moves.
bool TaughtProgram::circles(const RoundWay& way) {
  if (way.from != way.to) return false;
  const double turns = std::round(way.sweep_rad / kFullTurn_rad);
  const teach::Circle circle{pose(way.at(1 / (3 * turns))), pose(way.at(2 / (3 * turns)))};
  if (teach::objection_to_circle(pose(way.from), circle)) return false;
  for (double n = 0; n < turns; ++n) write(circle);
  return true;
}

void TaughtProgram::chords(const RoundWay& way) {
  const double count = way.chord_count(kTolerance_mm);
  for (double n = 1; n <= count; ++n) write(teach::Line{pose(way.at(n / count))});
}

void TaughtProgram::act(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, axes_);
  if (!plane) return;
  const RoundWay way(*plane, at_, arc);
  const double rise = plane->normal ? arc.to[*plane->normal] - at_[*plane->normal] : 0;
  const double mean_radius = (way.radius + way.end_radius) / 2;
  begin_path();
  if (feed(arc.feed, math::hypot(way.sweep_rad * mean_radius, rise))) {
    const double halves = std::ceil(way.sweep_rad / std::numbers::pi - 1e-9);
    const bool whole = way.sweep_rad < kFullTurn_rad && arcs(way, 1);
    if (!whole && !circles(way) && !arcs(way, std::max(2.0, halves))) chords(way);
  }
  at_ = arc.to;
}

void TaughtProgram::act(const motion::SpaceArc& arc) {
  const SpaceArcPath path(axes_, at_, arc);
  begin_path();
  if (feed(arc.feed, path.circle().length())) {
    if (arc.full_circle) {
      write(teach::Circle{pose(arc.via), pose(arc.second_via)});
    } else {
      write(teach::Arc{pose(arc.via), pose(arc.to)});
    }
  }
  at_ = arc.to;
}

void TaughtProgram::act(const motion::SurfaceMove& move) {
  const TipPoint from = at_;
  comment(" a move on a surface, in chords");
  const motion::SurfacePath path(axes_, from, move, [&](const motion::Curve& curve) {
    act(motion::Line{curve.end(), move.feed});
  });
}

void TaughtProgram::act(const Dwell& dwell) { write(teach::Dwell{dwell.seconds}); }

// The way to where a path begins is no cut: its point comes before the beam.
void TaughtProgram::act(const Power& power) {
  const double percent = power.beam_percent();
  if (percent > 0) begin_path();
  if (percent > 0 && power.follows_speed) comment(" power follows the speed");
  write(percent > 0 ? teach::Laser{true, percent} : teach::Laser{false, std::nullopt});
}

void TaughtProgram::act(const Spindle& spindle) {
  speed_rpm_ = spindle.known_rpm();
  comment(spindle.turns() ? " spindle on, " + number_text(speed_rpm_) + " rpm" : " spindle off");
}

void TaughtProgram::act(const ToolChange& change) {
  comment(" tool " + std::to_string(change.tool));
}

void TaughtProgram::act(const Coolant& coolant) {
  comment(coolant.state == Coolant::State::off ? " coolant off" : " coolant on");
}

void TaughtProgram::act(const AuxiliaryCode& code) { comment(" M" + std::to_string(code.code)); }
void TaughtProgram::act(const Stop& stop) {
  comment(stop.optional ? " optional stop" : " program stop");
}
void TaughtProgram::act(const Message& message) {
  comment(" message: " + std::string(message.text.view()));
}
void TaughtProgram::act(const End& /*end*/) { finish(); }

void TaughtProgram::take(const Motion& motion) {
  if (ended_) return;
  motion_ = &motion;
  std::visit([this](const auto& action) { act(action); }, motion.action);
}

void TaughtProgram::finish() {
  if (!ended_) write(teach::End{});
  ended_ = true;
}

}  // namespace kerf::output
