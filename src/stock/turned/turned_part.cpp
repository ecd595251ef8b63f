#include "stock/turned/turned_part.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/contour/boolean.hpp"
#include "math/math.hpp"
#include "stock/turned/ball_touch.hpp"
#include "stock/turned/half_plane_lines.hpp"
#include "stock/turned/met.hpp"
#include "stock/turned/revolved.hpp"
#include "stock/turned/tip_path.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Box;
using contour::Contour;
using contour::Division;
using contour::Region;
using contour::Vec2;

constexpr double kUpright = 1e-12;

Contour rectangle(Vec2 low, Vec2 high) {
  return {{{low}, {{high.u, low.v}}, {high}, {{low.u, high.v}}}};
}

Region above_axis(const Region& region) {
  const Box box = contour::extents(region);
  if (region.is_empty() || box.low.v >= -kOnAxis_mm) return region;
  return contour::subtract(
      region, contour::region_of(rectangle(box.low - Vec2{1, 1}, {box.high.u + 1, 0})));
}

Region moved(Region region, Vec2 by) {
  for (Contour& loop : region.loops) {
    for (contour::Vertex& vertex : loop.vertices) vertex.point = vertex.point + by;
  }
  return region;
}

/// Of a cutter that is wider than a lead what is in one turn of the thread.
Region one_turn(const TurnedTool::Part& cutter, const ThreadPass& pass) {
  const Vec2 way = pass.to - pass.from;
  Box turn = cutter.box;
  if (std::fabs(way.u) >= std::fabs(way.v)) {
    turn.low.u = turn.middle().u - pass.lead / 2;
    turn.high.u = turn.low.u + pass.lead;
  } else {
    turn.low.v = turn.middle().v - pass.lead / 2;
    turn.high.v = turn.low.v + pass.lead;
  }
  return contour::intersect(cutter.whole, contour::region_of(rectangle(turn.low, turn.high)));
}

}  // namespace

TurnedPart::TurnedPart(const Region& region)
    : material_(above_axis(region)), stock_mm3_(turned::volume(material_.region())) {}

BodyId TurnedPart::add_body(const Body& body) {
  tools_.emplace_back(body);
  return static_cast<BodyId>(tools_.size() - 1);
}

bool TurnedPart::can_cut(const Sweep& sweep) const {
  return sweep.body < tools_.size() && is_in_plane(sweep.way) &&
         (tools_[sweep.body].is_insert() || sweep.axis.z >= 1 - kUpright);
}

void TurnedPart::cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  assert(sweeps.size() == outcomes.size());
  std::vector<TurnedCut> cuts;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    cuts.clear();
    cut(sweeps[i], outcomes[i], cuts);
  }
}

void TurnedPart::cut(const Sweep& sweep, Outcome& outcome, std::vector<TurnedCut>& cuts) {
  const TurnedTool& tool = tools_[sweep.body];
  const Told told{outcome, cuts};
  const Pass pass{tip_path(sweep.way), sweep.motion};
  if (sweep.kind == SweepKind::rapid || !tool.cuts()) {
    meet(tool.cutter(), tool.touch_mm(), pass, sweep.body, told);
  } else if (sweep.lead_mm > 0 && tool.is_insert()) {
    cut_thread(tool, pass, sweep, told);
  } else {
    cut_with_edges(tool, pass, sweep.body, told);
  }
  // What the edges have cut is gone by now: what others meet is theirs.
  for (const TurnedTool::Part& part : tool.others())
    meet(part, tool.touch_mm(), pass, sweep.body, told);
}

void TurnedPart::cut_with_edges(const TurnedTool& tool, const Pass& pass, BodyId body,
                                const Told& told) {
  Outcome& outcome = told.outcome;
  const Box box = swept_box(tool.cutter().box, pass);
  if (!material_.may_meet(box)) return;
  outcome.visited += contour::vertex_count(region());
  Division division =
      material_.divide(swept(tool.cutter().whole, tool.cutter().is_convex, pass), box);
  if (division.inside.is_empty()) return;
  Region met = without_threads(division.inside, body);
  check_back(tool, pass, met, told);
  outcome.removed += Exact(turned::volume(met));
  outcome.section += Exact(contour::area(met));
  if (!tool.is_insert() && !met.is_empty()) {
    const Box all = contour::extents(met);
    outcome.aside.add({all.low.v, all.high.v});
  }
  const bool is_all = threads_.is_empty() || met == division.inside;
  become(is_all ? std::move(division.outside) : contour::subtract(region(), met));
  told.cuts.push_back({.region = std::move(met)});
}

void TurnedPart::become(contour::Region region) {
  material_.become(std::move(region));
  ++changes_;
}

void TurnedPart::restore(const State& state) {
  become(state.region);
  threads_ = state.threads;
}

void TurnedPart::check_back(const TurnedTool& tool, const Pass& pass, const Region& met,
                            const Told& told) const {
  if (tool.edges().empty() || met.is_empty()) return;
  const Box box = contour::extents(met);
  const std::vector<Contour> behind = swept(tool.back(), pass);
  const auto may_meet = [&](const Contour& loop) { return contour::extents(loop).meets(box); };
  if (std::none_of(behind.begin(), behind.end(), may_meet)) return;
  Region rest = contour::divide(met, swept(tool.edges(), pass)).outside;
  if (!counts(rest, tool.touch_mm())) return;
  const Region touched =
      contour::divide(rest, swept(tool.cutter().shrunk, tool.cutter().is_convex, pass)).inside;
  if (!counts(touched, tool.touch_mm())) return;
  told.outcome.contacts[index(ToolPart::flank)].add(contact_of(rest));
  told.cuts.push_back({.region = std::move(rest), .contact = ToolPart::flank, .is_taken = false});
}

void TurnedPart::meet(const TurnedTool::Part& part, double touch_mm, const Pass& pass, BodyId body,
                      const Told& told) {
  Outcome& outcome = told.outcome;
  const Box box = swept_box(part.box, pass);
  if (part.shrunk.is_empty() || !material_.may_meet(box)) return;
  outcome.visited += contour::vertex_count(region());
  const Region touched = material_.divide(swept(part.shrunk, part.is_convex, pass), box).inside;
  if (!counts(without_threads(touched, body), touch_mm)) return;
  Region met =
      without_threads(material_.divide(swept(part.whole, part.is_convex, pass), box).inside, body);
  outcome.contacts[index(part.part)].add(contact_of(met));
  outcome.removed += Exact(turned::volume(met));
  become(contour::subtract(region(), met));
  told.cuts.push_back({.region = std::move(met), .contact = part.part});
}

Region TurnedPart::without_threads(Region met, BodyId body) const {
  if (met.is_empty() || threads_.is_empty()) return met;
  const Region ring = threads_.ring(body);
  return ring.is_empty() ? met : contour::subtract(met, ring);
}

void TurnedPart::cut_thread(const TurnedTool& tool, const Pass& pass, const Sweep& sweep,
                            const Told& told) {
  const Box box = swept_box(tool.cutter().box, pass);
  if (!material_.may_meet(box)) return;
  ThreadPass thread{
      .body = sweep.body,
      .motion = sweep.motion,
      .from = pass.path.front().from,
      .to = pass.path.back().to,
      .lead = sweep.lead_mm,
      .start_deg = sweep.start_deg,
      .is_inside = !tool.is_outside(),
      .met =
          material_.divide(swept(tool.cutter().whole, tool.cutter().is_convex, pass), box).inside};
  if (thread.met.is_empty()) return;
  check_back(tool, pass, thread.met, told);
  thread.groove_mm3 = groove_mm3(tool, thread);
  told.outcome.threaded += Exact(turned::volume(threads_.add(thread)));
  ++changes_;
}

// The insert stands where the middle of what it meets is.
double TurnedPart::groove_mm3(const TurnedTool& tool, const ThreadPass& pass) const {
  const Vec2 way = pass.to - pass.from;
  const double square = dot(way, way);
  if (square == 0) return 0;
  const Vec2 middle = contour::extents(pass.met).middle();
  const double share = std::clamp(dot(middle - pass.from, way) / square, 0.0, 1.0);
  const Region tooth = one_turn(tool.cutter(), pass);
  return turned::volume(contour::intersect(region(), moved(tooth, pass.from + share * way)));
}

std::optional<double> TurnedPart::first_touch(const BallWay& ball) const {
  return turned::first_touch(region(), ball);
}

Stretch TurnedPart::material_on(const StraightWay& line) const {
  constexpr double kAside_mm = 1e-9;
  const Vec3 way = line.to - line.from;
  if (std::fabs(way.x) > kAside_mm || std::fabs(way.y) > kAside_mm) return {};
  std::vector<Crossing> crossings;
  HalfPlaneLines(region()).along_u(math::hypot(line.from.x, line.from.y), crossings);
  if (crossings.empty()) return {};
  return shares(line.from.z, line.to.z, crossings.front().at, crossings.back().at);
}

double TurnedPart::left_mm3() const { return turned::volume(region()); }
Bounds TurnedPart::extents() const { return turned::bounds(region()); }
std::vector<Piece> TurnedPart::pieces() const { return turned::pieces(region()); }

std::size_t TurnedPart::bytes() const {
  return sizeof(*this) + region().loops.size() * (sizeof(Contour) + sizeof(Box)) +
         contour::vertex_count(region()) * sizeof(contour::Vertex);
}

Region bar(double diameter, double from, double to, double inner_diameter) {
  return contour::region_of(rectangle({from, inner_diameter / 2}, {to, diameter / 2}));
}

}  // namespace kerf::stock::turned
