#include "features/rewrite/ruling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::features {
namespace {

using contour::Edge;
using contour::Region;
using contour::Vec2;

constexpr double kOnLine_mm = 1e-6;

/// An edge in parts that only rise or only fall towards later lines.
std::vector<Edge> rising_parts(const Edge& edge, Vec2 across) {
  if (edge.bulge == 0) return {edge};
  std::vector<double> shares{0};
  for (const double side : {-1.0, 1.0}) {
    const Vec2 extreme = contour::centre(edge) + (side * contour::radius(edge)) * across;
    const double share = contour::nearest_share(edge, extreme);
    const bool is_on_it = geometry::length(contour::point_at(edge, share) - extreme) <= kOnLine_mm;
    if (is_on_it && share > 1e-9 && share < 1 - 1e-9) shares.push_back(share);
  }
  shares.push_back(1);
  std::sort(shares.begin(), shares.end());
  std::vector<Edge> parts;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    if (shares[i] > shares[i - 1]) parts.push_back(contour::part(edge, shares[i - 1], shares[i]));
  }
  return parts;
}

/// Where a part of an edge meets a line, along it.
double meeting(const Edge& part, const Ruling& ruling, double line) {
  const double from = geometry::dot(part.from, ruling.across);
  const double to = geometry::dot(part.to, ruling.across);
  if (part.bulge == 0) {
    const Vec2 at = part.from + ((line - from) / (to - from)) * (part.to - part.from);
    return geometry::dot(at, ruling.along);
  }
  const Vec2 centre = contour::centre(part);
  const double radius = contour::radius(part);
  const double height = line - geometry::dot(centre, ruling.across);
  const double half = std::sqrt(std::max(0.0, radius * radius - height * height));
  const double side = geometry::dot(contour::point_at(part, 0.5) - centre, ruling.along);
  return geometry::dot(centre, ruling.along) + std::copysign(half, side);
}

// Ends on the line count as before it, or behind it.
std::vector<double> meetings(const Region& region, const Ruling& ruling, double line,
                             bool ends_are_behind) {
  const auto is_behind = [&](Vec2 point) {
    const double off = geometry::dot(point, ruling.across) - line;
    return std::fabs(off) <= kOnLine_mm ? ends_are_behind : off > 0;
  };
  std::vector<double> found;
  for (const contour::Contour& loop : region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
      for (const Edge& part : rising_parts(contour::edge_of(loop, i), ruling.across)) {
        if (is_behind(part.from) != is_behind(part.to))
          found.push_back(meeting(part, ruling, line));
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

Interval lines_across(const Region& region, const Ruling& ruling) {
  Interval all{1e300, -1e300};
  for (const contour::Contour& loop : region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
      for (const Edge& part : rising_parts(contour::edge_of(loop, i), ruling.across)) {
        const double at = geometry::dot(part.from, ruling.across);
        all = {std::min(all.from, at), std::max(all.to, at)};
      }
    }
  }
  return all;
}

std::vector<Interval> parts_of_line(const Region& region, const Ruling& ruling, double line) {
  std::vector<Interval> parts;
  for (const bool ends_are_behind : {false, true}) {
    const std::vector<double> ends = meetings(region, ruling, line, ends_are_behind);
    for (std::size_t i = 1; i < ends.size(); i += 2) parts.push_back({ends[i - 1], ends[i]});
  }
  std::sort(parts.begin(), parts.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  std::vector<Interval> joined;
  for (const Interval& part : parts) {
    if (!joined.empty() && part.from <= joined.back().to + kOnLine_mm) {
      joined.back().to = std::max(joined.back().to, part.to);
    } else {
      joined.push_back(part);
    }
  }
  return joined;
}

}  // namespace kerf::features
