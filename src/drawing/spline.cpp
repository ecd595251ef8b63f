#include "drawing/spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/cubic_spline.hpp"

namespace kerf::drawing {
namespace {

/// A point times its weight, and the weight.
struct Heavy {
  Vec2 moment;
  double weight = 0;
};

Heavy heavy(const Weighted& point) { return {point.weight * point.at, point.weight}; }
Weighted light(const Heavy& point) { return {(1 / point.weight) * point.moment, point.weight}; }

/// The value of the spline's polar form at `places`, as many as its degree, for the piece between
/// the knots `span` and span + 1: where they are all the same, a point of the curve; where they
/// are the piece's ends, one of its Bezier points (L. Ramshaw, "Blossoms are polar forms", 1989).
Weighted polar_value(const Spline& spline, std::size_t span, const std::vector<double>& places) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  std::array<Heavy, kLargestDegree + 1> row;
  for (std::size_t i = 0; i <= degree; ++i) row[i] = heavy(spline.points[span - degree + i]);
  for (std::size_t level = 1; level <= degree; ++level) {
    for (std::size_t i = degree; i >= level; --i) {
      const double from = spline.knots[span - degree + i];
      const double to = spline.knots[span + 1 + i - level];
      const double share = (places[level - 1] - from) / (to - from);
      row[i] = {(1 - share) * row[i - 1].moment + share * row[i].moment,
                (1 - share) * row[i - 1].weight + share * row[i].weight};
    }
  }
  return light(row[degree]);
}

/// The Bezier points of the piece between the knots `span` and span + 1.
std::vector<Weighted> bezier_of(const Spline& spline, std::size_t span) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  std::vector<double> places(degree, spline.knots[span]);
  std::vector<Weighted> points{polar_value(spline, span, places)};
  for (std::size_t i = 0; i < degree; ++i) {
    places[degree - 1 - i] = spline.knots[span + 1];
    points.push_back(polar_value(spline, span, places));
  }
  return points;
}

bool is_polynomial(const std::vector<Weighted>& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Weighted& point) { return point.weight == points.front().weight; });
}

void draw_piece(const std::vector<Weighted>& points, Pen& pen) {
  if (points.size() == 2) return pen.line_to(points[1].at);
  if (points.size() == 4 && is_polynomial(points))
    return pen.cubic_to(points[1].at, points[2].at, points[3].at);
  if (points.size() == 3 && is_polynomial(points))
    return pen.quadratic_to(points[1].at, points[2].at);
  pen.rational_to(points[0].weight, std::span(points).subspan(1));
}

std::size_t first_span(const Spline& spline) {
  auto span = static_cast<std::size_t>(spline.degree);
  while (spline.knots[span + 1] <= spline.knots[span]) ++span;
  return span;
}

bool is_apart(Vec2 a, Vec2 b) {
  constexpr double kSame = 1e-9;  // of what coordinates are large
  const double most = std::max({std::abs(a.u), std::abs(a.v), 1.0});
  return std::abs(a.u - b.u) > kSame * most || std::abs(a.v - b.v) > kSame * most;
}

}  // namespace

std::string fault_of(const Spline& spline) {
  const std::size_t count = spline.points.size();
  if (spline.degree < 1 || spline.degree > kLargestDegree)
    return fmt::format("has the degree {}, and 1 to {} can be drawn", spline.degree,
                       kLargestDegree);
  const auto degree = static_cast<std::size_t>(spline.degree);
  if (count <= degree)
    return fmt::format("has {} control points, too few for its degree {}", count, degree);
  if (spline.knots.size() != count + degree + 1)
    return fmt::format("has {} knots where its {} control points need {}", spline.knots.size(),
                       count, count + degree + 1);
  const bool is_finite = std::all_of(spline.knots.begin(), spline.knots.end(),
                                     [](double knot) { return std::isfinite(knot); });
  if (!is_finite || !std::is_sorted(spline.knots.begin(), spline.knots.end()))
    return "has knots that do not ascend";
  if (!(spline.knots[degree] < spline.knots[count])) return "has no length: its knots are the same";
  const bool is_light = std::any_of(spline.points.begin(), spline.points.end(),
                                    [](const Weighted& point) { return !(point.weight > 0); });
  return is_light ? "has a weight that is not above 0" : "";
}

Vec2 begin_of(const Spline& spline) {
  const std::size_t span = first_span(spline);
  const std::vector<double> places(static_cast<std::size_t>(spline.degree), spline.knots[span]);
  return polar_value(spline, span, places).at;
}

void draw(const Spline& spline, Pen& pen) {
  for (std::size_t span = first_span(spline); span < spline.points.size(); ++span) {
    if (spline.knots[span + 1] <= spline.knots[span]) continue;
    const std::vector<Weighted> points = bezier_of(spline, span);
    if (is_apart(points[0].at, pen.at())) pen.begin(points[0].at);
    draw_piece(points, pen);
  }
}

void take_out_twins(Through& through) {
  std::vector<Vec2>& points = through.points;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (through.is_closed && points.size() > 1 && points.back() == points.front())
    points.pop_back();
}

void draw(const Through& through, Pen& pen) {
  std::vector<Vec2> points = through.points;
  if (through.is_closed) points.push_back(points.front());
  std::vector<double> at{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    at.push_back(at.back() + geometry::length(points[i] - points[i - 1]));
  const auto slopes = [&](double Vec2::*axis) {
    std::vector<double> values;
    for (const Vec2& point : through.points) values.push_back(point.*axis);
    if (through.is_closed) return periodic_slopes(at, values);
    const auto end = [&](const std::optional<Vec2>& direction) {
      return direction ? std::optional(geometry::unit(*direction).*axis) : std::nullopt;
    };
    return spline_slopes(at, values, end(through.begins), end(through.ends));
  };
  const std::vector<double> along_u = slopes(&Vec2::u);
  const std::vector<double> along_v = slopes(&Vec2::v);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double third = (at[i + 1] - at[i]) / 3;
    const std::size_t next = (i + 1) % along_u.size();
    pen.cubic_to(points[i] + third * Vec2{along_u[i], along_v[i]},
                 points[i + 1] - third * Vec2{along_u[next], along_v[next]}, points[i + 1]);
  }
}

}  // namespace kerf::drawing
