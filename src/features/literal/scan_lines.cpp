#include "features/literal/scan_lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Contour;
using contour::Edge;
using contour::Vec2;

constexpr double kOnArc_mm = 1e-6;

/// x = at, or with `is_level` y = at.
struct ScanLine {
  double at = 0;
  bool is_level = false;

  [[nodiscard]] double off(Vec2 point) const { return (is_level ? point.v : point.u) - at; }
  [[nodiscard]] double along(Vec2 point) const { return is_level ? point.u : point.v; }
  [[nodiscard]] Vec2 point(double along) const {
    return is_level ? Vec2{along, at} : Vec2{at, along};
  }
};

void cross_line(const Edge& edge, const ScanLine& line, std::vector<double>& crossings) {
  const double from = line.off(edge.from);
  const double to = line.off(edge.to);
  if ((from > 0) == (to > 0)) return;
  crossings.push_back(line.along(edge.from + (from / (from - to)) * (edge.to - edge.from)));
}

/// False: the line touches the arc.
bool cross_arc(const Edge& edge, const ScanLine& line, std::vector<double>& crossings) {
  const Vec2 centre = contour::centre(edge);
  const double radius = contour::radius(edge);
  const double off = line.off(centre);
  if (std::fabs(std::fabs(off) - radius) <= kSamePoint_mm) return false;
  if (std::fabs(off) > radius) return true;
  const double half = std::sqrt(radius * radius - off * off);
  for (const double side : {-half, half}) {
    const double along = line.along(centre) + side;
    if (contour::distance(edge, line.point(along)) <= kOnArc_mm) crossings.push_back(along);
  }
  return true;
}

/// Where a line crosses a contour, in order; nothing: the line does not count.
std::optional<std::vector<double>> crossings_of(const Contour& contour, const ScanLine& line) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
    const Edge edge = contour::edge_of(contour, i);
    if (std::fabs(line.off(edge.from)) <= kSamePoint_mm) return std::nullopt;
    if (edge.bulge == 0) {
      cross_line(edge, line, crossings);
    } else if (!cross_arc(edge, line, crossings)) {
      return std::nullopt;
    }
  }
  if (crossings.size() < 2 || crossings.size() % 2 != 0) return std::nullopt;
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

/// How many crossings lie in the ranges between pairs of others.
std::size_t inside_count(const std::vector<double>& ranges, const std::vector<double>& crossings) {
  std::size_t count = 0;
  for (const double crossing : crossings) {
    const auto behind = std::upper_bound(ranges.begin(), ranges.end(), crossing);
    count += static_cast<std::size_t>((behind - ranges.begin()) % 2);
  }
  return count;
}

/// What the lines have seen so far.
struct Seen {
  bool inside = false;
  bool outside = false;

  void look(const Contour& first, const Contour& second, const ScanLine& line) {
    const auto ranges = crossings_of(first, line);
    const auto crossings = crossings_of(second, line);
    if (!ranges || !crossings) return;
    const std::size_t count = inside_count(*ranges, *crossings);
    inside = inside || count > 0;
    outside = outside || count < crossings->size();
  }
};

}  // namespace

ScanRelation scan_relation(const Contour& first, const Contour& second, int count) {
  Box box = contour::extents(first);
  box.take(contour::extents(second));
  if (box.is_empty()) return ScanRelation::undecided;
  const Vec2 size = box.high - box.low;
  Seen seen;
  for (int k = 0; k < count; ++k) {
    const double share = (k + 0.5) / count;
    seen.look(first, second, {box.low.u + share * size.u, false});
    seen.look(first, second, {box.low.v + share * size.v, true});
  }
  if (seen.inside && seen.outside) return ScanRelation::partial;
  if (seen.inside) return ScanRelation::contains;
  return seen.outside ? ScanRelation::none : ScanRelation::undecided;
}

}  // namespace kerf::features
