#include "geometry/contour/passage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/contour/internal/arrangement.hpp"
#include "math/math.hpp"

namespace kerf::contour {
namespace {

constexpr double kPi = std::numbers::pi;
// Angles that are no farther from each other are one: where a fold meets the corner of a patch.
constexpr double kSameAngle = 1e-13;

Vec2 towards(double angle) {
  const auto [sine, cosine] = math::sine_cosine(angle);
  return {cosine, sine};
}

Edge moved(const Edge& edge, Vec2 by) {
  return {edge.from + by, edge.to + by, edge.bulge, edge.owner};
}

/// The loop of edges in a row, in the sense that goes round it counterclockwise.
Contour loop_of(std::span<const Edge> edges, bool is_forwards) {
  Contour loop;
  for (const Edge& edge : edges) loop.vertices.push_back({edge.from, edge.bulge, edge.owner});
  return is_forwards ? loop : reversed(loop);
}

/// Parts of a curve that cross `way` in one sense each, in order.
std::vector<Edge> parts_across(const Edge& curve, Vec2 way) {
  if (curve.bulge == 0) return {curve};
  const Vec2 start = tangent_at_start(curve);
  const double sweep = sweep_rad(curve);
  const double sign = sweep > 0 ? 1 : -1;
  double turn = sign * math::atan2(cross(start, way), dot(start, way));
  while (turn <= kSameAngle) turn += kPi;
  std::vector<Edge> parts;
  double share = 0;
  for (; turn < std::fabs(sweep) - kSameAngle; turn += kPi) {
    const double next = turn / std::fabs(sweep);
    parts.push_back(part(curve, share, next));
    share = next;
  }
  parts.push_back(share == 0 ? curve : part(curve, share, 1));
  return parts;
}

Vec2 tangent_in(const Edge& curve) {
  return curve.bulge == 0 ? curve.to - curve.from : tangent_at_start(part(curve, 0.5, 1));
}

// A part of a curve that crosses `way` in one sense.
void add_strip(const Edge& curve, Vec2 way, std::vector<Contour>& loops) {
  const Edge ahead = moved(curve, way);
  const std::array<Edge, 4> edges{Edge{curve.from, curve.to, curve.bulge, curve.owner},
                                  Edge{curve.to, ahead.to, 0, curve.owner}, reversed(ahead),
                                  Edge{ahead.from, curve.from, 0, curve.owner}};
  loops.push_back(loop_of(edges, cross(tangent_in(curve), way) > 0));
}

void add_strips(const Edge& curve, Vec2 way, std::vector<Contour>& loops) {
  for (const Edge& one : parts_across(curve, way)) add_strip(one, way, loops);
}

/// An arc as an angle that grows.
struct Turn {
  Vec2 centre;
  double radius = 0;
  double from = 0;
  double to = 0;
};

Turn turn_of(const Edge& edge) {
  const Edge ahead = edge.bulge > 0 ? edge : reversed(edge);
  const Vec2 middle = centre(ahead);
  const Vec2 start = ahead.from - middle;
  const double from = math::atan2(start.v, start.u);
  return {middle, radius(ahead), from, from + sweep_rad(ahead)};
}

/// A place in the sum of two arcs: the angles on both.
struct Angles {
  double first = 0;
  double second = 0;

  [[nodiscard]] double fold() const { return second - first; }
};

/// A polygon of angles, convex, at most six corners.
using Patch = std::vector<Angles>;

Angles crossing(Angles a, Angles b, double fold) {
  const double share = (fold - a.fold()) / (b.fold() - a.fold());
  Angles out{a.first + share * (b.first - a.first), a.second + share * (b.second - a.second)};
  if (a.first == b.first) out.second = out.first + fold;
  if (a.second == b.second) out.first = out.second - fold;
  return out;
}

/// What of the patch has its fold on one side of a limit.
Patch clipped(const Patch& patch, double limit, double sign) {
  Patch out;
  const auto over = [&](Angles a) { return sign * (a.fold() - limit); };
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const Angles here = patch[i];
    const Angles next = patch[(i + 1) % patch.size()];
    if (over(here) >= 0) out.push_back(here);
    if ((over(here) > 0 && over(next) < 0) || (over(here) < 0 && over(next) > 0))
      out.push_back(crossing(here, next, limit));
  }
  return out;
}

bool is_same(Angles a, Angles b) {
  return std::fabs(a.first - b.first) <= kSameAngle && std::fabs(a.second - b.second) <= kSameAngle;
}

/// Along the sides of a patch one angle stays, or both grow alike: an arc of the other's radius, or
/// of the sum or difference of both.
double turn_between(Angles a, Angles b) {
  const double first = b.first - a.first;
  return std::fabs(first) > kSameAngle ? first : b.second - a.second;
}

void add_patch(const Turn& a, const Turn& b, const Patch& patch, bool is_forwards,
               std::uint32_t owner, std::vector<Contour>& loops) {
  Contour loop;
  Patch corners;
  for (const Angles& corner : patch) {
    if (corners.empty() || !is_same(corners.back(), corner)) corners.push_back(corner);
  }
  while (corners.size() > 1 && is_same(corners.front(), corners.back())) corners.pop_back();
  if (corners.size() < 3) return;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Angles here = corners[i];
    const double turn = turn_between(here, corners[(i + 1) % corners.size()]);
    const Vec2 point =
        a.centre + b.centre + a.radius * towards(here.first) + b.radius * towards(here.second);
    loop.vertices.push_back({point, math::tan(turn / 4), owner});
  }
  loops.push_back(is_forwards ? loop : reversed(loop));
}

// The sum a(θ) + b(φ) of two arcs goes round counterclockwise where sin(φ - θ) > 0.
void add_arcs(const Edge& edge, const Edge& way, std::vector<Contour>& loops) {
  const Turn a = turn_of(edge);
  const Turn b = turn_of(way);
  const Patch all{{a.from, b.from}, {a.to, b.from}, {a.to, b.to}, {a.from, b.to}};
  const auto first = static_cast<int>(std::floor((b.from - a.to) / kPi));
  const auto last = static_cast<int>(std::floor((b.to - a.from) / kPi));
  for (int k = first; k <= last; ++k) {
    const Patch patch = clipped(clipped(all, k * kPi, 1), (k + 1) * kPi, -1);
    add_patch(a, b, patch, k % 2 == 0, edge.owner, loops);
  }
}

void add_passage(const Edge& edge, const Edge& way, std::vector<Contour>& loops) {
  if (way.bulge == 0) return add_strips(moved(edge, way.from), way.to - way.from, loops);
  if (edge.bulge != 0) return add_arcs(edge, way, loops);
  Edge along = moved(way, edge.from);
  along.owner = edge.owner;
  add_strips(along, edge.to - edge.from, loops);
}

}  // namespace

std::vector<Contour> passage(std::span<const Edge> edges, const Edge& way) {
  std::vector<Contour> loops;
  loops.reserve(edges.size() * 2);
  if (way.from == way.to) return loops;
  for (const Edge& edge : edges) {
    if (!(edge.from == edge.to)) add_passage(edge, way, loops);
  }
  return loops;
}

std::vector<Contour> passage(const Region& region, const Edge& way) {
  std::vector<Edge> edges;
  for (const Contour& loop : region.loops) {
    for (std::size_t i = 0; i < edge_count(loop); ++i) edges.push_back(edge_of(loop, i));
  }
  std::vector<Contour> loops = passage(edges, way);
  for (Contour loop : region.loops) {
    for (Vertex& vertex : loop.vertices) vertex.point = vertex.point + way.from;
    loops.push_back(std::move(loop));
  }
  return loops;
}

bool is_convex(const Contour& loop) {
  const std::size_t count = edge_count(loop);
  for (std::size_t i = 0; i < count; ++i) {
    const Edge edge = edge_of(loop, i);
    const Vec2 out = tangent_at_start(edge_of(loop, (i + 1) % count));
    const Vec2 in = tangent_at_end(edge);
    const double bend = cross(in, out);
    const double product = geometry::length(in) * geometry::length(out);
    if (edge.bulge < 0 || bend < -1e-9 * product) return false;
    if (bend < 1e-9 * product && dot(in, out) < 0) return false;
  }
  return loop.is_closed && count > 1 && area(loop) > 0;
}

// The side that looks ahead is where the way ends, the other one where it begins.
Contour convex_passage(const Contour& loop, const Edge& way) {
  const Vec2 along = way.to - way.from;
  Contour all;
  for (std::size_t i = 0; i < edge_count(loop); ++i) {
    for (const Edge& one : parts_across(edge_of(loop, i), along)) {
      const bool looks_ahead = cross(tangent_in(one), along) < 0;
      const Vec2 by = looks_ahead ? way.to : way.from;
      const Vec2 from = one.from + by;
      if (!all.vertices.empty() && all.vertices.back().point == from) all.vertices.pop_back();
      all.vertices.push_back({from, one.bulge, one.owner});
      all.vertices.push_back({one.to + by, 0, one.owner});
    }
  }
  if (all.vertices.size() > 1 && all.vertices.back().point == all.vertices.front().point)
    all.vertices.pop_back();
  return all;
}

Division divide(const Region& region, const std::vector<Contour>& by) {
  const auto arranged = [&](const std::vector<Contour>& loops) {
    std::vector<Strand> strands;
    add_strands(strands, region.loops, Operand::first);
    add_strands(strands, loops, Operand::second);
    return Arrangement(std::move(strands));
  };
  Arrangement all = arranged(by);
  // Many contours through each other may be too much for rounding where their outline is not.
  if (!all.is_sound()) all = arranged(covered(by).loops);
  return {{all.loops([](Winding w) { return w.first > 0 && w.second > 0; })},
          {all.loops([](Winding w) { return w.first > 0 && w.second <= 0; })}};
}

Region covered(const std::vector<Contour>& loops) {
  std::vector<Strand> strands;
  add_strands(strands, loops, Operand::first);
  return {Arrangement(std::move(strands)).loops([](Winding w) { return w.first > 0; })};
}

}  // namespace kerf::contour
