#include "features/tree/normal_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Vec2;

constexpr double kSameCurve_mm = 1e-6;  // how far neighbours may lie beside one line or circle
constexpr double kShort_mm = 1e-7;
constexpr double kSliver_mm = 4e-3;   // of inches with four digits, and of arcs
constexpr double kRoundedArc = 1e-3;  // of half a circle, that a half circle may be more

/// A line, or an arc by its whole angle, which may be more than half a circle.
struct Piece {
  Vec2 from, to;
  double sweep_rad = 0;
  Vec2 centre;
  double radius = 0;
  std::uint32_t owner = 0;

  [[nodiscard]] bool is_line() const { return sweep_rad == 0; }
};

Piece piece_of(const Edge& edge) {
  Piece piece{.from = edge.from, .to = edge.to, .centre = {}, .owner = edge.owner};
  if (edge.bulge == 0) return piece;
  piece.sweep_rad = contour::sweep_rad(edge);
  piece.centre = contour::centre(edge);
  piece.radius = contour::radius(edge);
  return piece;
}

bool goes_on_straight(const Piece& a, const Piece& b) {
  const Vec2 way = b.to - a.from;
  const double chord = geometry::length(way);
  if (chord < kSameCurve_mm) return false;
  return std::fabs(geometry::cross(way, a.to - a.from)) <= kSameCurve_mm * chord &&
         geometry::dot(a.to - a.from, b.to - b.from) > 0;
}

bool goes_on_round(const Piece& a, const Piece& b) {
  const double tolerance = kSameCurve_mm * std::max(1.0, a.radius);
  return (a.sweep_rad > 0) == (b.sweep_rad > 0) && std::fabs(a.radius - b.radius) <= tolerance &&
         geometry::length(a.centre - b.centre) <= tolerance;
}

bool goes_on(const Piece& a, const Piece& b) {
  if (a.is_line() != b.is_line()) return false;
  return a.is_line() ? goes_on_straight(a, b) : goes_on_round(a, b);
}

std::vector<Piece> long_pieces(const Contour& contour) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
    const Edge edge = contour::edge_of(contour, i);
    if (contour::length(edge) >= kShort_mm) pieces.push_back(piece_of(edge));
  }
  return pieces;
}

// Where a closed contour is rotated to, so that its first piece does not go on from its last one.
void begin_at_corner(std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
    if (goes_on(before, pieces[i])) continue;
    std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i), pieces.end());
    return;
  }
}

std::vector<Piece> merged(const std::vector<Piece>& pieces) {
  std::vector<Piece> longer;
  for (const Piece& piece : pieces) {
    if (longer.empty() || !goes_on(longer.back(), piece)) {
      longer.push_back(piece);
      continue;
    }
    longer.back().to = piece.to;
    longer.back().sweep_rad += piece.sweep_rad;
  }
  return longer;
}

Contour circle(const Piece& piece) {
  const Vec2 arm{piece.radius, 0};
  const double bulge = piece.sweep_rad > 0 ? 1 : -1;
  return {{{piece.centre - arm, bulge, piece.owner}, {piece.centre + arm, bulge, piece.owner}},
          true};
}

Vec2 turned(Vec2 arm, double angle_rad) {
  const double c = math::cos(angle_rad);
  const double s = math::sin(angle_rad);
  return {c * arm.u - s * arm.v, s * arm.u + c * arm.v};
}

void append(const Piece& piece, Contour& contour) {
  const double half_turns = std::fabs(piece.sweep_rad) / std::numbers::pi;
  const int parts = std::max(1, static_cast<int>(std::ceil(half_turns - kRoundedArc)));
  const double bulge = piece.is_line() ? 0 : math::tan(piece.sweep_rad / parts / 4);
  const Vec2 arm = piece.from - piece.centre;
  for (int part = 0; part < parts; ++part) {
    const Vec2 at =
        part == 0 ? piece.from : piece.centre + turned(arm, piece.sweep_rad * part / parts);
    contour.vertices.push_back({at, bulge, piece.owner});
  }
}

bool is_whole_circle(const std::vector<Piece>& pieces) {
  return pieces.size() == 1 && !pieces[0].is_line() &&
         std::fabs(pieces[0].sweep_rad) > 2 * std::numbers::pi - 1e-6;
}

void begin_at_least(Contour& contour) {
  const auto least = std::min_element(contour.vertices.begin(), contour.vertices.end(),
                                      [](const auto& a, const auto& b) {
                                        if (std::fabs(a.point.u - b.point.u) > kSameCurve_mm)
                                          return a.point.u < b.point.u;
                                        return a.point.v < b.point.v;
                                      });
  std::rotate(contour.vertices.begin(), least, contour.vertices.end());
}

bool is_near(const Edge& a, const Edge& b, double tolerance) {
  return geometry::length(a.from - b.from) <= tolerance &&
         geometry::length(contour::point_at(a, 0.5) - contour::point_at(b, 0.5)) <= tolerance;
}

bool are_equal_from(const Contour& a, const Contour& b, std::size_t shift, double tolerance) {
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const std::size_t j = (i + shift) % b.vertices.size();
    if (!is_near(contour::edge_of(a, i), contour::edge_of(b, j), tolerance)) return false;
  }
  return true;
}

}  // namespace

Contour normal_form(const Contour& contour) {
  std::vector<Piece> pieces = long_pieces(contour);
  if (contour.is_closed) begin_at_corner(pieces);
  pieces = merged(pieces);
  Contour normal{{}, contour.is_closed};
  if (contour.is_closed && is_whole_circle(pieces)) {
    normal = circle(pieces[0]);
  } else {
    for (const Piece& piece : pieces) append(piece, normal);
  }
  if (!contour.is_closed) {
    if (!contour.vertices.empty()) normal.vertices.push_back(contour.vertices.back());
    return normal;
  }
  if (normal.vertices.empty()) return normal;
  if (!contour::is_counterclockwise(normal)) normal = contour::reversed(normal);
  begin_at_least(normal);
  return normal;
}

Contour without_slivers(const Contour& contour, double least) {
  Contour longer{{}, true};
  double left_out = 0;  // in a row: many short ones are a curve
  for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
    left_out += contour::length(contour::edge_of(contour, i));
    if (left_out < least) continue;
    left_out = 0;
    longer.vertices.push_back(contour.vertices[i]);
  }
  return longer.vertices.size() < 2 ? contour : longer;
}

bool is_sliver(const Contour& loop) {
  return std::fabs(contour::area(loop)) <= kSliver_mm * contour::length(loop) / 2;
}

bool are_equal(const Contour& a, const Contour& b, double tolerance) {
  if (a.vertices.size() != b.vertices.size() || a.is_closed != b.is_closed) return false;
  if (a.vertices.empty()) return true;
  for (std::size_t shift = 0; shift < b.vertices.size(); ++shift) {
    if (geometry::length(a.vertices[0].point - b.vertices[shift].point) > tolerance) continue;
    if (are_equal_from(a, b, shift, tolerance)) return true;
  }
  return false;
}

}  // namespace kerf::features
