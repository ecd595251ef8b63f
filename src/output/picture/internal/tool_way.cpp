#include "output/picture/internal/tool_way.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kNoWay = 1e-6;  // mm
constexpr double kChord = 0.01;  // mm
constexpr std::size_t kMostPlunges = 256;

// From the axis of rotation.
double outward(const Point3& from, const Point3& to) {
  return std::abs(to[kX]) - std::abs(from[kX]);
}

void add_cut(ToolWay& way, const Point3& from, const Point3& to) {
  if (!way.cuts) way.first = from;
  way.cuts = true;
  way.last = to;
  for (std::size_t i = 0; i < to.size(); ++i) way.middle[i] = (from[i] + to[i]) / 2;
  const double dz = std::abs(to[kZ] - from[kZ]), dx = std::abs(to[kX] - from[kX]);
  way.along = way.along || dz > kNoWay;
  way.across = way.across || dx > kNoWay;
  way.on_axis = way.on_axis && std::abs(from[kX]) < kNoWay && std::abs(to[kX]) < kNoWay;
  const bool plunge = dx > kNoWay && dz <= kNoWay;
  if (plunge && way.plunges.size() < kMostPlunges) way.plunges.push_back(from[kZ]);
}

// Down the flank behind which an insert must not be wider than the way is steep.
void add_slope(ToolWay& way, const Point3& from, const Point3& to) {
  constexpr double kWall_deg = 86;
  const double dz = to[kZ] - from[kZ], dx = outward(from, to);
  const bool down = way.inside() ? dx > kNoWay : dx < -kNoWay;
  if (dz >= -kNoWay || !down) return;
  const double steep_deg = geometry::degrees(math::atan2(std::abs(dx), -dz));
  if (steep_deg < kWall_deg) way.steepest_deg = std::max(way.steepest_deg, steep_deg);
}

// The first rapid behind a cut says on which side the tool stands.
void add_leaving(std::vector<ToolWay>& ways, const Path& path) {
  for (std::size_t i = 1; i < path.strokes.size(); ++i) {
    const Pen& before = path.strokes[i - 1].pen;
    if (path.strokes[i].pen.trace != Trace::travel || before.trace != Trace::cut) continue;
    const auto travel = path.vertices_of(i);
    if (travel.size() < 2 || path.vertices_of(i - 1).back().at != travel[0].at) continue;
    constexpr double kMost = 2;  // the way home is no better witness than a retreat
    ways[before.tool].outward_mm += std::clamp(outward(travel[0].at, travel[1].at), -kMost, kMost);
  }
}

}  // namespace

std::vector<ToolWay> ways_of(const Path& path, std::size_t pens) {
  std::vector<ToolWay> ways(pens);
  add_leaving(ways, path);
  for_each_cut(path, kChord, [&](const Pen& pen, const Point3& from, const Point3& to) {
    add_cut(ways[pen.tool], from, to);
    add_slope(ways[pen.tool], from, to);
  });
  for (ToolWay& way : ways) std::ranges::sort(way.plunges);
  return ways;
}

}  // namespace kerf::output::plot
