#include "output/records/row_csv.hpp"

#include <cmath>
#include <variant>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"
#include "geometry/arc.hpp"
#include "motion/feed.hpp"
#include "motion/plane_axes.hpp"
#include "motion/space_arc_path.hpp"
#include "motion/surface_path.hpp"
#include "output/programs/post.hpp"

namespace kerf::output {

using namespace motion;

RowCsv::RowCsv(const AxisSetup& axes, const control::Memory& memory, base::OutputFile& file)
    : axes_(axes),
      memory_(memory),
      file_(file),
      xyz_{axes.find('X'), axes.find('Y'), axes.find('Z')},
      at_(axes.start) {
  file_.write("line,G,X,Y,Z,I,J,K,R,T,F,A\n");
}

RowCsv::Xyz RowCsv::xyz_of(const base::TipPoint& point) const {
  Xyz xyz{};
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    if (xyz_[i]) xyz[i] = point[*xyz_[i]];
  }
  return xyz;
}

// Along the linear axes; of a rotary-only move in degrees.
double RowCsv::length_to(const base::TipPoint& to) const {
  double linear = 0;
  double rotary = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const double way = to.values[i] - at_.values[i];
    (axes_.axes[i].rotary ? rotary : linear) += way * way;
  }
  return std::sqrt(linear > 0 ? linear : rotary);
}

double RowCsv::tool_radius() const {
  if (tool_ >= memory_.tools.size()) return 0;
  const control::ToolOffset& offset = memory_.tools[tool_];
  return base::tidy(offset.radius_geometry + offset.radius_wear);
}

void RowCsv::straight(std::string_view code, const base::TipPoint& to, const Feed& feed) {
  feed_ = base::tidy(motion::feed_per_minute(feed, length_to(to), speed_rpm_));
  move(code, to, {}, feed_);
}

void RowCsv::arc(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, axes_);
  if (!plane) return;
  const geometry::Vec2 from = plane->project(at_);
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  const bool clockwise = arc.direction == Direction::clockwise;
  const double length =
      geometry::arc_length(from, plane->project(arc.to), centre, clockwise, arc.turns, 0);
  feed_ = base::tidy(motion::feed_per_minute(arc.feed, length, speed_rpm_));
  base::TipPoint to_centre;
  plane->place(to_centre, {base::tidy(centre.u - from.u), base::tidy(centre.v - from.v)});
  move(clockwise ? "2" : "3", arc.to, xyz_of(to_centre), feed_);
}

void RowCsv::space_arc(const SpaceArc& arc) {
  const SpaceArcPath path(axes_, at_, arc);
  const geometry::SpaceArc& circle = path.circle();
  feed_ = base::tidy(motion::feed_per_minute(arc.feed, circle.length(), speed_rpm_));
  path.chords(geometry::chord_angle_rad(circle.radius(), Post::kChordTolerance_mm),
              [&](const base::TipPoint& to) { move("1", to, {}, feed_); });
}

// The rows have no column for the rotary axis: the ends of its curves.
void RowCsv::surface_move(const SurfaceMove& surface_move) {
  std::vector<base::TipPoint> ends;
  const SurfacePath path(axes_, at_, surface_move,
                         [&](const Curve& curve) { ends.push_back(curve.end()); });
  feed_ = base::tidy(motion::feed_per_minute(surface_move.feed, path.length(), speed_rpm_));
  for (const base::TipPoint& to : ends) move("1", to, {}, feed_);
}

void RowCsv::move(std::string_view code, const base::TipPoint& to, const Xyz& centre, double feed) {
  const Xyz begin = xyz_of(at_);
  const Xyz end = xyz_of(to);
  write(code, end, centre, feed, geometry::heading_deg({begin[0], begin[1]}, {end[0], end[1]}));
  at_ = to;
}

void RowCsv::write(std::string_view code, const Xyz& to, const Xyz& centre, double feed,
                   double heading) {
  row_.clear();
  base::append_integer(row_, line_);
  row_ += ',';
  row_ += code;
  const auto number = [&](double value) {
    row_ += ',';
    base::append_number(row_, value);
  };
  for (const double value : to) number(value);
  for (const double value : centre) number(value);
  number(tool_radius());
  row_ += ',';
  base::append_integer(row_, tool_);
  number(feed);
  number(heading);
  row_ += '\n';
  file_.write(row_);
}

void RowCsv::take(const Motion& motion) {
  line_ = motion.block.line;
  if (const auto* const rapid = std::get_if<Rapid>(&motion.action)) {
    move("0", rapid->to, {}, 0);
  } else if (const auto* const line = std::get_if<Line>(&motion.action)) {
    straight("1", line->to, line->feed);
  } else if (const auto* const in_plane = std::get_if<Arc>(&motion.action)) {
    arc(*in_plane);
  } else if (const auto* const in_space = std::get_if<SpaceArc>(&motion.action)) {
    space_arc(*in_space);
  } else if (const auto* const on_surface = std::get_if<SurfaceMove>(&motion.action)) {
    surface_move(*on_surface);
  } else if (const auto* const probe = std::get_if<Probe>(&motion.action)) {
    straight("31", probe->to, probe->feed);
  } else if (const auto* const thread = std::get_if<Thread>(&motion.action)) {
    straight("33", thread->to, {thread->lead, FeedMode::per_revolution});
  } else if (const auto* const change = std::get_if<ToolChange>(&motion.action)) {
    tool_ = change->tool;
    write("T", xyz_of(at_), {}, feed_, kToolChange_deg);
  } else if (const auto* const spindle = std::get_if<Spindle>(&motion.action)) {
    speed_rpm_ = spindle->known_rpm();
  }
}

}  // namespace kerf::output
