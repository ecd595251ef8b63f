#include "output/records/lathe_row_csv.hpp"

#include <variant>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"
#include "motion/plane_axes.hpp"
#include "motion/surface_path.hpp"

namespace kerf::output {
namespace {

using geometry::Vec2;

constexpr double kChange_deg = 720;

}  // namespace

LatheRowCsv::LatheRowCsv(const machine::MachineDefinition& machine, const control::Memory& memory,
                         base::OutputFile& file)
    : machine_(machine),
      memory_(memory),
      file_(file),
      x_(*machine.axes.find('X')),
      z_(*machine.axes.find('Z')),
      at_(machine.axes.start) {
  file_.write("line,G,X,Z,I,K,R,T,F,A\n");
}

double LatheRowCsv::nose_radius() const {
  return memory_.nose(offset_, machine_.parameters.geometry_by_tool ? tool_ : offset_).radius_mm;
}

double LatheRowCsv::turn_deg(Vec2 leaves) const {
  if (length(came_) == 0 || length(leaves) == 0) return geometry::kNoHeading_deg;
  return geometry::heading_deg({}, geometry::unit(Vec2{dot(came_, leaves), cross(came_, leaves)}));
}

void LatheRowCsv::act(const motion::Line& line) { cut("1", line.to, line.feed.value); }
void LatheRowCsv::act(const motion::Probe& probe) { cut("31", probe.to, probe.feed.value); }
void LatheRowCsv::act(const motion::Thread& thread) { cut("32", thread.to, thread.lead); }

void LatheRowCsv::act(const motion::Arc& arc) {
  const auto plane = motion::plane_axes(arc.plane, machine_.axes);
  if (!plane || !plane->contains(x_) || !plane->contains(z_))
    return cut("1", arc.to, arc.feed.value);
  const bool clockwise = arc.direction == motion::Direction::clockwise;
  const Vec2 centre{arc.center[0], arc.center[1]};
  const auto forward = [&](Vec2 from_centre) {
    return clockwise ? -geometry::left_of(from_centre) : geometry::left_of(from_centre);
  };
  const Vec2 begin = zx(at_) - centre;
  const Move move{clockwise ? "2" : "3", arc.to, forward(begin), forward(zx(arc.to) - centre),
                  -begin};
  write(move, feed_ = arc.feed.value, turn_deg(move.leaves));
}

// The rows have no column for the rotary axis.
void LatheRowCsv::act(const motion::SurfaceMove& move) {
  std::vector<base::TipPoint> ends;
  const motion::SurfacePath path(machine_.axes, at_, move,
                                 [&](const motion::Curve& curve) { ends.push_back(curve.end()); });
  for (const base::TipPoint& to : ends) cut("1", to, move.feed.value);
}

void LatheRowCsv::act(const motion::ToolChange& change) {
  tool_ = change.tool;
  write({"T", at_, {}, {}}, feed_, kChange_deg);
}

void LatheRowCsv::cut(std::string_view code, const base::TipPoint& to, double feed) {
  feed_ = feed;
  straight(code, to);
}

void LatheRowCsv::straight(std::string_view code, const base::TipPoint& to) {
  const Vec2 way = zx(to) - zx(at_);
  write({code, to, way, way}, code == "0" ? 0 : feed_, turn_deg(way));
}

void LatheRowCsv::write(const Move& move, double feed, double turn_deg) {
  row_.clear();
  base::append_integer(row_, line_);
  row_ += ',';
  row_ += move.code;
  const auto number = [&](double value) {
    row_ += ',';
    base::append_number(row_, value);
  };
  number(move.to[x_] * machine_.axes[x_].count_per_mm());
  number(move.to[z_]);
  number(base::tidy(move.to_centre.v));
  number(base::tidy(move.to_centre.u));
  number(nose_radius());
  row_ += ',';
  base::append_integer(row_, tool_);
  number(base::tidy(feed));
  number(turn_deg);
  row_ += '\n';
  file_.write(row_);
  at_ = move.to;
  came_ = move.arrives;
}

void LatheRowCsv::take(const motion::Motion& motion) {
  line_ = motion.block.line;
  offset_ = motion.length.offset;
  std::visit(
      [this](const auto& action) {
        if constexpr (requires { this->act(action); }) act(action);
      },
      motion.action);
}

}  // namespace kerf::output
