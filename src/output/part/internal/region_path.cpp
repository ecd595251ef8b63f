#include "output/part/internal/region_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

using geometry::Vec2;

constexpr double kQuarter = 1.5707963267948966;

struct Side {
  Point a;
  Point b;
};

/// Straight sides of a region on the sheet, for hatching.
std::vector<Side> sides_of(const contour::Region& region, const ToSheet& to_sheet) {
  constexpr double kChords = 24;  // of half a circle
  std::vector<Side> sides;
  for (const contour::Contour& loop : region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
      const contour::Edge edge = contour::edge_of(loop, i);
      const double count =
          std::max(1.0, std::ceil(std::fabs(contour::sweep_rad(edge)) / (2 * kQuarter) * kChords));
      Point last = to_sheet(edge.from);
      for (double k = 1; k <= count; ++k) {
        const Point next = to_sheet(k == count ? edge.to : contour::point_at(edge, k / count));
        sides.push_back({last, next});
        last = next;
      }
    }
  }
  return sides;
}

}  // namespace

void follow(Outline& outline, const contour::Edge& edge, const ToSheet& to_sheet) {
  if (edge.bulge == 0) {
    outline.line_to(to_sheet(edge.to));
    return;
  }
  const double sweep = contour::sweep_rad(edge);
  const double parts = std::max(1.0, std::ceil(std::fabs(sweep) / kQuarter - 1e-9));
  const Vec2 centre = contour::centre(edge);
  // Handles of a Bezier curve for an arc: 4/3 tan(a/4) of the radius along the tangents.
  const double handle = 4.0 / 3 * math::tan(sweep / parts / 4);
  Vec2 from = edge.from;
  for (double k = 1; k <= parts; ++k) {
    const Vec2 to = k == parts ? edge.to : contour::point_at(edge, k / parts);
    const Vec2 one = from + handle * geometry::left_of(from - centre);
    const Vec2 other = to - handle * geometry::left_of(to - centre);
    outline.curve_to(to_sheet(one), to_sheet(other), to_sheet(to));
    from = to;
  }
}

Outline path_of(const contour::Region& region, const ToSheet& to_sheet) {
  Outline outline;
  for (const contour::Contour& loop : region.loops) {
    if (loop.vertices.empty()) continue;
    outline.move_to(to_sheet(loop.vertices.front().point));
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i)
      follow(outline, contour::edge_of(loop, i), to_sheet);
    outline.close();
  }
  return outline;
}

Outline hatch(const contour::Region& region, const ToSheet& to_sheet, double apart) {
  Outline lines;
  const std::vector<Side> sides = sides_of(region, to_sheet);
  const auto across = [](Point p) { return p.x + p.y; };
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Side& side : sides) {
    low = std::min(low, across(side.a));
    high = std::max(high, across(side.a));
  }
  for (double c = (std::floor(low / apart) + 0.5) * apart; c < high; c += apart) {
    std::vector<double> crossed;  // x of the places where the line passes a side
    for (const auto& [a, b] : sides) {
      const double from = across(a) - c;
      const double to = across(b) - c;
      if ((from > 0) == (to > 0)) continue;
      crossed.push_back(a.x + from / (from - to) * (b.x - a.x));
    }
    std::sort(crossed.begin(), crossed.end());
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2)
      lines.segment({crossed[i], c - crossed[i]}, {crossed[i + 1], c - crossed[i + 1]});
  }
  return lines;
}

}  // namespace kerf::output::plot
