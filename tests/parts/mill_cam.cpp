#include "mill_cam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kerf::parts {
namespace {

using contour::Edge;

constexpr double kOverrun_mm = 1;

/// Where a line at y = `height` crosses an edge, as values of x.
void add_crossings(const Edge& edge, double height, std::vector<double>& xs) {
  if (edge.bulge == 0) {
    const double a = edge.from.v - height;
    const double b = edge.to.v - height;
    if ((a < 0) != (b < 0)) xs.push_back(edge.from.u + a / (a - b) * (edge.to.u - edge.from.u));
    return;
  }
  const Vec2 middle = contour::centre(edge);
  const double radius = contour::radius(edge);
  const double up = height - middle.v;
  if (std::fabs(up) >= radius) return;
  const double half = std::sqrt(radius * radius - up * up);
  for (const double x : {middle.u - half, middle.u + half}) {
    if (contour::distance(edge, {x, height}) < 1e-6) xs.push_back(x);
  }
}

/// The lowest and highest x of a convex contour at a height.
std::optional<std::array<double, 2>> row_of(const Contour& contour, double height) {
  std::vector<double> xs;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i)
    add_crossings(contour::edge_of(contour, i), height, xs);
  if (xs.size() < 2) return std::nullopt;
  const auto [low, high] = std::minmax_element(xs.begin(), xs.end());
  if (*high - *low < 0.1) return std::nullopt;
  return std::array{*low, *high};
}

std::vector<double> heights_between(double low, double high, double step) {
  const auto count = static_cast<int>(std::ceil((high - low) / step)) + 1;
  std::vector<double> heights;
  for (int i = 0; i < count; ++i) heights.push_back(low + (high - low) * (i + 0.5) / count);
  return heights;
}

std::vector<Edge> rows_of(const Contour& region, const Contour* island, double step) {
  const contour::Box box = contour::extents(region);
  std::vector<Edge> rows;
  for (const double y : heights_between(box.low.v, box.high.v, step)) {
    const auto row = row_of(region, y);
    if (!row) continue;
    const auto gap = island != nullptr ? row_of(*island, y) : std::nullopt;
    if (!gap) {
      rows.push_back({{(*row)[0], y}, {(*row)[1], y}});
      continue;
    }
    rows.push_back({{(*row)[0], y}, {(*gap)[0], y}});
    rows.push_back({{(*gap)[1], y}, {(*row)[1], y}});
  }
  return rows;
}

Vec2 start_of(const Contour& loop) { return loop.vertices.front().point; }

}  // namespace

void MillCam::go(const Edge& edge) {
  if (edge.bulge == 0) return posted_.line(edge.to);
  posted_.arc(edge.to, contour::centre(edge), edge.bulge > 0);
}

void MillCam::follow(const Contour& loop) {
  posted_.line(start_of(loop));
  for (std::size_t i = 0; i < contour::edge_count(loop); ++i) go(contour::edge_of(loop, i));
}

// There and back along the way to a point, half of the depth each.
void MillCam::ramp(Vec2 to, double top, double z) {
  const Vec2 begin = posted_.at();
  posted_.plunge(top + 0.5);
  posted_.line(to, (top + 0.5 + z) / 2);
  posted_.line(begin, z);
}

void MillCam::helix(Vec2 at, Vec2 middle, double top, double z) {
  const double pitch = radius_ / 2;
  const int turns = static_cast<int>(std::ceil((top + 0.5 - z) / pitch));
  posted_.plunge(top + 0.5);
  for (int i = 1; i <= turns; ++i)
    posted_.arc(at, top + 0.5 + (z - top - 0.5) * i / turns, middle, true);
}

void MillCam::enter(const Contour& first, double top, double z, Way::Entry entry) {
  retract();
  posted_.rapid(start_of(first));
  posted_.rapid_z(top + 2);
  if (entry == Way::Entry::ramp)
    return ramp(contour::point_at(contour::edge_of(first, 0), 0.5), top, z);
  posted_.plunge(z);
}

void MillCam::loops(std::vector<Contour> all, double top, double z, const Way& way) {
  if (way.is_inside_out) std::reverse(all.begin(), all.end());
  bool is_down = false;
  for (Contour& loop : all) {
    if (!way.climbs) loop = contour::reversed(loop);
    if (!is_down || way.retracts) enter(loop, top, z, way.entry);
    is_down = true;
    follow(loop);
  }
  retract();
}

void MillCam::spiral(const Outline& outline, double top, double z, const Way& way) {
  const Contour last = outline.inset(radius_);
  const double reach = contour::radius(contour::edge_of(last, 0));
  const Vec2 middle = outline.middle();
  const int halves = static_cast<int>(std::ceil(2 * reach / way.step));
  retract();
  posted_.rapid(middle);
  posted_.rapid_z(top + 2);
  posted_.plunge(z);
  Vec2 at = middle;
  for (int i = 1; i <= halves; ++i) {
    const Vec2 to = middle + Vec2{(i % 2 == 0 ? 1 : -1) * reach * i / halves, 0};
    posted_.arc(to, 0.5 * (at + to), way.climbs);
    at = to;
  }
  posted_.arc(at, middle, way.climbs);
  retract();
}

// Without a way down beside them lines would leave their ends round.
void MillCam::lines(const std::vector<Edge>& rows, double top, double z, const Way& way) {
  bool is_down = false;
  bool is_back = false;
  for (const Edge& row : rows) {
    const Edge way_of_row = is_back ? contour::reversed(row) : row;
    if (!is_down || way.strategy == Way::Strategy::zig) {
      retract();
      posted_.rapid(way_of_row.from);
      posted_.rapid_z(top + 2);
      posted_.plunge(z);
      is_down = true;
    }
    posted_.line(way_of_row.from);
    posted_.line(way_of_row.to);
    is_back = way.strategy == Way::Strategy::zig_zag && !is_back;
  }
}

void MillCam::pocket(const Outline& outline, double top, double z, const Way& way) {
  if (way.strategy == Way::Strategy::spiral) return spiral(outline, top, z, way);
  Contour wall = outline.inset(radius_);
  if (way.strategy != Way::Strategy::parallel) {
    lines(rows_of(wall, nullptr, way.step), top, z, way);
    if (!way.climbs) wall = contour::reversed(wall);
    if (way.retracts) enter(wall, top, z, Way::Entry::plunge);
    follow(wall);
    return retract();
  }
  std::vector<Contour> all;
  for (double d = radius_;; d += way.step) {
    const Contour loop = outline.inset(d);
    if (loop.vertices.empty()) break;
    all.push_back(loop);
  }
  if (way.entry != Way::Entry::helix) return loops(std::move(all), top, z, way);
  const double small = std::min(radius_ / 2, (outline.inner_radius() - radius_) / 2);
  const Vec2 at = outline.middle() + Vec2{small, 0};
  retract();
  posted_.rapid(at);
  posted_.rapid_z(top + 2);
  helix(at, outline.middle(), top, z);
  if (way.is_inside_out) std::reverse(all.begin(), all.end());
  for (const Contour& loop : all) follow(way.climbs ? loop : contour::reversed(loop));
  retract();
}

// Behind the island a line begins anew.
void MillCam::pocket(const Outline& outline, const Outline& island, double top, double z,
                     const Way& way) {
  Contour wall = outline.inset(radius_);
  Contour round = island.outset(radius_);
  Way rows = way;
  rows.strategy = Way::Strategy::zig;
  lines(rows_of(wall, &round, way.step), top, z, rows);
  (way.climbs ? round : wall) = contour::reversed(way.climbs ? round : wall);
  for (const Contour* const loop : {&wall, &round}) {
    enter(*loop, top, z, Way::Entry::plunge);
    follow(*loop);
  }
  retract();
}

void MillCam::ring_pocket(Vec2 middle, double inner, double outer, double top, double z,
                          const Way& way) {
  const double first = inner + radius_;
  const double last = outer - radius_;
  const int steps = std::max(1, static_cast<int>(std::ceil((last - first) / way.step)));
  std::vector<Contour> all;
  for (int i = steps; i >= 0; --i)
    all.push_back(Outline::circle(middle, first + (last - first) * i / steps).drawn());
  loops(std::move(all), top, z, way);
}

void MillCam::corner(Vec2 low, Vec2 high, Open open, double top, double z, const Way& way) {
  const double out = radius_ + kOverrun_mm;
  const auto end = [&](double wall, bool is_open, double inwards) {
    return wall + inwards * (is_open ? -out : radius_);
  };
  const Vec2 from{end(low.u, open.left, 1), end(low.v, open.low, 1)};
  const Vec2 to{end(high.u, open.right, -1), end(high.v, open.high, -1)};
  std::vector<Edge> rows;
  const int count = std::max(1, static_cast<int>(std::ceil((to.v - from.v) / way.step)));
  for (int i = 0; i <= count; ++i) {
    const double y = from.v + (to.v - from.v) * i / count;
    rows.push_back({{from.u, y}, {to.u, y}});
  }
  lines(rows, top, z, way);
  retract();
  if (open.left && open.right) return;
  // The ends of the lines have left rests on the walls across; once along each of these.
  for (const bool is_left : {true, false}) {
    if (is_left ? open.left : open.right) continue;
    const double x = is_left ? from.u : to.u;
    pass({{{{x, from.v}}, {{x, to.v}}}, false}, top, z, Way::Entry::plunge);
  }
}

void MillCam::pass(const Contour& path, double top, double z, Way::Entry entry) {
  enter(path, top, z, entry);
  for (std::size_t i = 0; i < contour::edge_count(path); ++i) go(contour::edge_of(path, i));
  retract();
}

void MillCam::profile(const Outline& outline, double top, double z, bool climbs, bool leads) {
  Contour loop = outline.outset(radius_);
  if (climbs) loop = contour::reversed(loop);
  const Vec2 start = start_of(loop);
  const Vec2 beside = start + (radius_ / 2) * geometry::unit(start - outline.middle());
  retract();
  posted_.rapid(leads ? beside : start);
  posted_.rapid_z(top + 2);
  posted_.plunge(z);
  follow(loop);
  if (leads) posted_.line(beside);
  retract();
}

void MillCam::finish(const Outline& outline, double top, double z, bool climbs) {
  Contour loop = outline.inset(radius_);
  if (!climbs) loop = contour::reversed(loop);
  enter(loop, top, z, Way::Entry::plunge);
  follow(loop);
  retract();
}

void MillCam::plunges(Vec2 at, double z, int pecks) {
  retract();
  posted_.rapid(at);
  for (int i = 1; i <= pecks; ++i) {
    posted_.plunge(z * i / pecks);
    retract();
  }
}

void MillCam::helix_hole(Vec2 middle, double hole_radius, double top, double z, double pitch) {
  const Vec2 at = middle + Vec2{hole_radius - radius_, 0};
  const int turns = std::max(1, static_cast<int>(std::ceil((top - z) / pitch)));
  retract();
  posted_.rapid(at);
  posted_.plunge(top);
  for (int i = 1; i <= turns; ++i) posted_.arc(at, top + (z - top) * i / turns, middle, true);
  posted_.arc(at, middle, true);
  retract();
}

}  // namespace kerf::parts
