#include "features/literal/circle_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using geometry::Vec2;

constexpr std::size_t kLeastChords = 12;
constexpr double kMostChord_rad = std::numbers::pi / 4;
constexpr double kTurn_rad = 2 * std::numbers::pi;

std::optional<Circle> by_arcs(const Contour& contour) {
  const Edge first = contour::edge_of(contour, 0);
  const Circle circle{contour::centre(first), contour::radius(first)};
  double sweep = 0;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
    const Edge edge = contour::edge_of(contour, i);
    if (edge.bulge == 0) return std::nullopt;
    if (geometry::length(contour::centre(edge) - circle.centre) > kSamePoint_mm ||
        std::fabs(contour::radius(edge) - circle.radius) > kSamePoint_mm)
      return std::nullopt;
    sweep += contour::sweep_rad(edge);
  }
  return std::fabs(std::fabs(sweep) - kTurn_rad) < 1e-6 ? std::optional(circle) : std::nullopt;
}

// Least squares of u² + v² = 2 a u + 2 b v + c about the mean of the points.
std::optional<Circle> fitted(const Contour& contour) {
  const auto n = static_cast<double>(contour.vertices.size());
  Vec2 mean;
  for (const auto& vertex : contour.vertices) mean = mean + (1 / n) * vertex.point;
  double uu = 0, uv = 0, vv = 0, uw = 0, vw = 0, w_sum = 0;
  for (const auto& vertex : contour.vertices) {
    const Vec2 p = vertex.point - mean;
    const double w = geometry::dot(p, p);
    uu += p.u * p.u;
    uv += p.u * p.v;
    vv += p.v * p.v;
    uw += p.u * w;
    vw += p.v * w;
    w_sum += w;
  }
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return std::nullopt;
  const Vec2 arm{(uw * vv - vw * uv) / determinant / 2, (vw * uu - uw * uv) / determinant / 2};
  return Circle{mean + arm, std::sqrt(w_sum / n + geometry::dot(arm, arm))};
}

bool turns_once(const Contour& contour, Vec2 centre) {
  double sweep = 0;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
    const Edge edge = contour::edge_of(contour, i);
    const Vec2 a = edge.from - centre;
    const Vec2 b = edge.to - centre;
    const double angle = math::atan2(geometry::cross(a, b), geometry::dot(a, b));
    if (std::fabs(angle) > kMostChord_rad) return false;
    sweep += angle;
  }
  return std::fabs(std::fabs(sweep) - kTurn_rad) < 1e-6;
}

std::optional<Circle> by_chords(const Contour& contour) {
  const std::size_t count = contour.vertices.size();
  const bool is_straight = std::all_of(contour.vertices.begin(), contour.vertices.end(),
                                       [](const auto& vertex) { return vertex.bulge == 0; });
  if (!is_straight || count < kLeastChords) return std::nullopt;
  const auto circle = fitted(contour);
  if (!circle || !turns_once(contour, circle->centre)) return std::nullopt;
  const double flat =
      1.1 * circle->radius * (1 - math::cos(std::numbers::pi / static_cast<double>(count)));
  const double tolerance = std::max(kSamePoint_mm, flat);
  const bool is_near =
      std::all_of(contour.vertices.begin(), contour.vertices.end(), [&](const auto& vertex) {
        return std::fabs(geometry::length(vertex.point - circle->centre) - circle->radius) <=
               tolerance;
      });
  return is_near ? circle : std::nullopt;
}

}  // namespace

std::optional<Circle> circle_of(const Contour& contour) {
  if (contour.vertices.empty() || !contour.is_closed) return std::nullopt;
  return contour.vertices[0].bulge != 0 ? by_arcs(contour) : by_chords(contour);
}

}  // namespace kerf::features
