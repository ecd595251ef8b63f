#include "drawing/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "drawing/pen.hpp"
#include "geometry/contour/edge.hpp"

namespace kerf::drawing {
namespace {

using contour::Edge;

std::vector<Edge> edges_of(Vec2 from, const std::vector<Step>& steps) {
  std::vector<Edge> edges;
  for (const Step& step : steps) {
    edges.push_back({from, step.to, step.bulge});
    from = step.to;
  }
  return edges;
}

double distance_to(const std::vector<Edge>& edges, Vec2 point) {
  double least = 1e300;
  for (const Edge& edge : edges) least = std::min(least, distance(edge, point));
  return least;
}

double length_of(const std::vector<Edge>& edges) {
  double sum = 0;
  for (const Edge& edge : edges) sum += length(edge);
  return sum;
}

/// The largest turn between an edge and the next one.
double sharpest(const std::vector<Edge>& edges) {
  double most = 0;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const Vec2 a = tangent_at_end(edges[i - 1]);
    const Vec2 b = tangent_at_start(edges[i]);
    most = std::max(most, std::abs(std::atan2(geometry::cross(a, b), geometry::dot(a, b))));
  }
  return most;
}

Vec2 on_cubic(const std::array<Vec2, 4>& p, double t) {
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

TEST(Fit, a_cubic_of_the_manual_has_its_length_and_keeps_its_tangents) {
  const std::array<Vec2, 4> cubic{Vec2{0, 0}, Vec2{10, 30}, Vec2{20, -30}, Vec2{30, 0}};
  std::vector<Step> steps;
  Fit fit{steps, 0.01, 0};
  fit_cubic(cubic, fit);
  const std::vector<Edge> edges = edges_of(cubic[0], steps);
  EXPECT_NEAR(length_of(edges), 47.8608297, 1e-3);
  EXPECT_LT(sharpest(edges), 1e-6);
  EXPECT_LE(fit.error, 0.01);
  EXPECT_LT(edges.size(), 70U);
}

TEST(Fit, random_cubics_are_within_what_was_said_of_them_both_ways) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-40, 40);
  for (int i = 0; i < 400; ++i) {
    std::array<Vec2, 4> cubic{};
    for (Vec2& point : cubic) point = {place(random), place(random)};
    std::vector<Step> steps;
    Fit fit{steps, 0.01, 0};
    fit_cubic(cubic, fit);
    const std::vector<Edge> edges = edges_of(cubic[0], steps);
    ASSERT_LE(fit.error, 0.01);
    for (int k = 0; k <= 200; ++k)
      ASSERT_LE(distance_to(edges, on_cubic(cubic, k / 200.0)), fit.error + 1e-9)
          << i << " at " << k;
    double chords = 0;
    for (int k = 0; k < 4000; ++k)
      chords += geometry::length(on_cubic(cubic, (k + 1) / 4000.0) - on_cubic(cubic, k / 4000.0));
    ASSERT_NEAR(length_of(edges), chords, 0.05) << i;  // nothing twice, nothing left out
  }
}

TEST(Fit, a_quarter_that_stands_for_a_circle_is_an_arc) {
  constexpr double kappa = 0.5522847498;
  std::vector<Step> steps;
  Fit fit{steps, 0.01, 0};
  fit_cubic({Vec2{3, 0}, Vec2{3, 3 * kappa}, Vec2{3 * kappa, 3}, Vec2{0, 3}}, fit);
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_NEAR(steps[0].bulge, std::tan(std::numbers::pi / 8), 1e-6);
  EXPECT_LE(fit.error, 0.001);
}

TEST(Fit, a_straight_cubic_that_turns_back_goes_there_and_back) {
  std::vector<Step> steps;
  Fit fit{steps, 0.01, 0};
  fit_cubic({Vec2{0, 0}, Vec2{30, 0}, Vec2{-20, 0}, Vec2{10, 0}}, fit);
  const std::vector<Edge> edges = edges_of({0, 0}, steps);
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_GT(edges[0].to.u, 5);
  EXPECT_LT(edges[1].to.u, edges[0].to.u);
  for (const Edge& edge : edges) EXPECT_EQ(edge.bulge, 0);
}

TEST(Fit, an_ellipse_has_its_length) {
  std::vector<Step> steps;
  Fit fit{steps, 0.01, 0};
  fit_ellipse({{0, 0}, {25, 0}, {0, 20}}, 0, 2 * std::numbers::pi, fit);
  const std::vector<Edge> edges = edges_of({25, 0}, steps);
  EXPECT_NEAR(length_of(edges), 141.808339299, 0.01);
  EXPECT_LT(sharpest(edges), 1e-6);
  for (int k = 0; k < 500; ++k) {
    const double angle = k * 2 * std::numbers::pi / 500;
    EXPECT_LE(distance_to(edges, {25 * std::cos(angle), 20 * std::sin(angle)}), fit.error + 1e-9);
  }
}

TEST(Fit, a_rational_quarter_is_the_arc_that_it_is) {
  std::vector<Step> steps;
  Fit fit{steps, 0.01, 0};
  const std::array<Weighted, 3> quarter{
      Weighted{{1005, 7}, 1}, Weighted{{1005, 12}, std::sqrt(0.5)}, Weighted{{1000, 12}, 1}};
  fit_rational(quarter, fit);
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_NEAR(steps[0].bulge, std::tan(std::numbers::pi / 8), 1e-9);
  EXPECT_LT(fit.error, 1e-9);
}

TEST(Fit, random_rational_curves_of_every_degree_are_within_what_was_said_of_them) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-40, 40);
  std::uniform_real_distribution<double> weight(0.3, 3);
  for (int i = 0; i < 200; ++i) {
    const std::size_t degree = 1 + static_cast<std::size_t>(i) % 10;
    std::vector<Weighted> points;
    for (std::size_t k = 0; k <= degree; ++k)
      points.push_back({{place(random), place(random)}, weight(random)});
    std::vector<Step> steps;
    Fit fit{steps, 0.01, 0};
    fit_rational(points, fit);
    const std::vector<Edge> edges = edges_of(points[0].at, steps);
    for (int k = 0; k <= 200; ++k) {
      std::vector<Weighted> left = points;
      const double t = k / 200.0;
      for (Weighted& point : left) point.at = point.weight * point.at;
      while (left.size() > 1) {
        for (std::size_t n = 0; n + 1 < left.size(); ++n)
          left[n] = {(1 - t) * left[n].at + t * left[n + 1].at,
                     (1 - t) * left[n].weight + t * left[n + 1].weight};
        left.pop_back();
      }
      ASSERT_LE(distance_to(edges, (1 / left[0].weight) * left[0].at), fit.error + 1e-8)
          << i << " at " << k;
    }
  }
}

}  // namespace
}  // namespace kerf::drawing
