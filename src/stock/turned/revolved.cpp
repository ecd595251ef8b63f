#include "stock/turned/revolved.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "math/math.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Region;
using contour::Vec2;

constexpr double kPi = std::numbers::pi;
// Loops that reach as far as another one, but for rounding.
constexpr double kAsFar_mm = 1e-6;

/// x - sin x cos x, half the area of a segment of the unit circle whose angle is 2x; as a series
/// where the difference would lose digits.
double segment_share(double x) {
  if (std::fabs(x) > 0.25) return x - math::sin(x) * math::cos(x);
  const double square = 4 * x * x;
  double term = 2 * x * square / 6;
  double sum = 0;
  for (int k = 3; k < 19; k += 2) {
    sum += term;
    term *= -square / ((k + 1) * (k + 2));
  }
  return sum / 2;
}

// Between the chord and the axis.
double under_chord(const Edge& edge) {
  const double a = edge.from.v;
  const double b = edge.to.v;
  return -kPi / 3 * (edge.to.u - edge.from.u) * (a * a + a * b + b * b);
}

// Pappus: 2π times the moment of the segment between arc and chord about the axis. That is its area
// times ρ of the middle of the chord, and its moment about the chord, 2/3 c³ - A r cos x with half
// the chord c and half the angle x.
double of_segment(const Edge& edge) {
  const Vec2 chord = edge.to - edge.from;
  const double length = geometry::length(chord);
  if (edge.bulge == 0 || length == 0) return 0;
  const double x = 2 * math::atan(std::fabs(edge.bulge));
  const double sine = math::sin(x);
  const double c = length / 2;
  const double r = c / sine;
  const double area = r * r * segment_share(x);
  const double moment = 2.0 / 3 * c * c * c - area * r * math::cos(x);
  const double signed_area = edge.bulge > 0 ? area : -area;
  return 2 * kPi * (signed_area * (edge.from.v + edge.to.v) / 2 - moment * chord.u / length);
}

double volume_of(const Contour& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
    const Edge edge = contour::edge_of(loop, i);
    sum += under_chord(edge) + of_segment(edge);
  }
  return sum;
}

/// Owners of the edges, rising.
std::vector<std::uint32_t> cut_by(const Region& part) {
  std::vector<std::uint32_t> motions;
  for (const Contour& loop : part.loops) {
    for (const contour::Vertex& vertex : loop.vertices) {
      if (vertex.owner > 0) motions.push_back(vertex.owner);
    }
  }
  std::sort(motions.begin(), motions.end());
  motions.erase(std::unique(motions.begin(), motions.end()), motions.end());
  if (motions.size() > Piece::kMostCutBy)
    motions.erase(motions.begin(), motions.end() - Piece::kMostCutBy);
  return motions;
}

bool is_larger(const Piece& a, const Piece& b) {
  return std::tuple(-a.volume_mm3, a.extents.low.z) < std::tuple(-b.volume_mm3, b.extents.low.z);
}

}  // namespace

double volume(const Region& region) {
  double sum = 0;
  for (const Contour& loop : region.loops) sum += volume_of(loop);
  return sum;
}

Bounds bounds(const Region& region) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  if (region.is_empty()) return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  const contour::Box box = contour::extents(region);
  return {{-box.high.v, -box.high.v, box.low.u}, {box.high.v, box.high.v, box.high.u}};
}

std::vector<Piece> pieces(const Region& region) {
  const auto parents = contour::parents(region);
  std::vector<Region> parts(region.loops.size());
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    const bool is_outer = contour::is_counterclockwise(region.loops[i]);
    if (!is_outer && !parents[i]) continue;
    parts[is_outer ? i : *parents[i]].loops.push_back(region.loops[i]);
  }
  std::vector<Piece> out;
  double farthest = std::numeric_limits<double>::infinity();
  for (const Region& part : parts) {
    if (part.is_empty()) continue;
    out.push_back({volume(part), bounds(part), false, cut_by(part)});
    farthest = std::min(farthest, out.back().extents.low.z);
  }
  for (Piece& piece : out) {
    piece.held = piece.extents.low.z <= farthest + kAsFar_mm;
    if (piece.held) piece.cut_by.clear();
  }
  std::stable_sort(out.begin(), out.end(), is_larger);
  return out;
}

}  // namespace kerf::stock::turned
