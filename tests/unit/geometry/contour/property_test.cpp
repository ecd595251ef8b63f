#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <tuple>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "geometry/contour/relation.hpp"
#include "geometry/intersect.hpp"
#include "random_shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names

// The same cases on every run; others: RC_PARAMS="seed=7 max_success=1000".
[[maybe_unused]] const int kSeeded = setenv("RC_PARAMS", "seed=20260101", 0);

// Corners on a grid of 5 mm, bulges of lines, quarters and halves: edges meet in their ends, lie on
// each other, touch, have no length, and go round things twice.
using Corners = std::vector<std::tuple<int, int, int>>;

rc::Gen<Corners> corners() {
  return rc::gen::container<Corners>(
      rc::gen::tuple(rc::gen::inRange(-4, 5), rc::gen::inRange(-4, 5), rc::gen::inRange(0, 6)));
}

Contour tangle(const Corners& corners, std::uint32_t owner) {
  constexpr double kBulges[] = {0, 0, kQuarterBulge, -kQuarterBulge, 1, -1};
  Contour contour;
  for (const auto& [u, v, bulge] : corners) {
    contour.vertices.push_back({{5.0 * u, 5.0 * v}, kBulges[bulge], owner++});
  }
  return contour;
}

Region any_region(std::uint32_t first_owner = 0) {
  return region_of(tangle(*corners(), first_owner));
}

Region mapped(const Region& region, double angle_rad, Vec2 shift) {
  Region result;
  for (const Contour& loop : region.loops)
    result.loops.push_back(test::mapped(loop, angle_rad, shift));
  return result;
}

Region mirrored(const Region& region) {
  Region result;
  for (const Contour& loop : region.loops) result.loops.push_back(reversed(test::mirrored(loop)));
  return result;
}

double any_distance() { return *rc::gen::inRange(-40, 41) * 0.25; }

std::vector<Edge> edges_of(const Region& region) {
  std::vector<Edge> edges;
  for (const Contour& loop : region.loops) {
    for (std::size_t i = 0; i < edge_count(loop); ++i) edges.push_back(edge_of(loop, i));
  }
  return edges;
}

geometry::Curve curve_of(const Edge& edge) {
  if (edge.bulge == 0) return {false, edge.from, edge.to - edge.from, 0};
  return {true, centre(edge), {}, radius(edge)};
}

// Well inside of both, by 1 micrometre.
bool cross_inside(const Edge& a, const Edge& b) {
  const auto found = geometry::intersect(curve_of(a), curve_of(b), 0);
  for (std::size_t i = 0; i < found.count; ++i) {
    const Vec2 p = found.points[i];
    bool is_inside = true;
    for (const Edge& edge : {a, b}) {
      is_inside = is_inside && distance(edge, p) < 1e-7 && geometry::length(p - edge.from) > 1e-3 &&
                  geometry::length(p - edge.to) > 1e-3;
    }
    const Vec2 ta = tangent_at_start(part(a, nearest_share(a, p), 1));
    const Vec2 tb = tangent_at_start(part(b, nearest_share(b, p), 1));
    const double sine = cross(ta, tb) / (geometry::length(ta) * geometry::length(tb));
    if (is_inside && std::fabs(sine) > 1e-3) return true;
  }
  return false;
}

void expect_valid(const Region& region) {
  const std::vector<Edge> edges = edges_of(region);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    RC_ASSERT(geometry::length(edges[i].to - edges[i].from) > 1e-9);
    for (std::size_t k = i + 1; k < edges.size(); ++k) {
      RC_ASSERT(!cross_inside(edges[i], edges[k]));
    }
  }
  const auto above = parents(region);
  for (std::size_t i = 0; i < above.size(); ++i) {
    std::size_t depth = 0;
    for (auto parent = above[i]; parent; parent = above[*parent]) ++depth;
    RC_ASSERT((area(region.loops[i]) > 0) == (depth % 2 == 0));
  }
}

void expect_same(const Region& a, const Region& b) {
  RC_ASSERT(std::fabs(area(symmetric_difference(a, b))) < 1e-5);
  RC_ASSERT(std::fabs(area(a) - area(b)) < 1e-5);
}

constexpr double kSum = 1e-6;

RC_GTEST_PROP(Boolean, UnionAndIntersectionHaveTheAreasOfBoth, ()) {
  const Region a = any_region();
  const Region b = any_region();
  RC_ASSERT(std::fabs(area(unite(a, b)) + area(intersect(a, b)) - area(a) - area(b)) < kSum);
}

RC_GTEST_PROP(Boolean, WhatIsLeftAndWhatIsCommonMakeTheWhole, ()) {
  const Region a = any_region();
  const Region b = any_region();
  expect_same(unite(subtract(a, b), intersect(a, b)), a);
  expect_same(unite(subtract(a, b), subtract(b, a)), symmetric_difference(a, b));
}

RC_GTEST_PROP(Boolean, WithItselfIsItselfOrNothing, ()) {
  const Region a = any_region();
  RC_ASSERT(relation(unite(a, a), a).relation == Relation::equal);
  RC_ASSERT(relation(intersect(a, a), a).relation == Relation::equal);
  RC_ASSERT(subtract(a, a).is_empty());
  RC_ASSERT(symmetric_difference(a, a).is_empty());
}

RC_GTEST_PROP(Boolean, MakesValidRegions, ()) {
  const Region a = any_region();
  const Region b = any_region();
  for (const Region& each : {a, unite(a, b), intersect(a, b), subtract(a, b)}) expect_valid(each);
}

RC_GTEST_PROP(Boolean, OfMovedTurnedAndMirroredRegionsIsMovedTurnedAndMirrored, ()) {
  const Region a = any_region();
  const Region b = any_region();
  const double angle = *rc::gen::inRange(0, 628) * 0.01;
  const Vec2 shift{*rc::gen::inRange(-1000, 1000) * 1.1, *rc::gen::inRange(-1000, 1000) * 0.7};
  const auto turn = [&](const Region& region) { return mapped(region, angle, shift); };
  expect_same(subtract(turn(a), turn(b)), turn(subtract(a, b)));
  expect_same(unite(turn(a), turn(b)), turn(unite(a, b)));
  expect_same(subtract(mirrored(a), mirrored(b)), mirrored(subtract(a, b)));
}

RC_GTEST_PROP(Boolean, EdgesLieOnEdgesOfTheirOwners, ()) {
  const Contour first = tangle(*corners(), 0);
  const Contour second = tangle(*corners(), 1000);
  for (const Edge& edge : edges_of(subtract(region_of(first), region_of(second)))) {
    const Contour& owner = edge.owner < 1000 ? first : second;
    const std::size_t index = edge.owner % 1000;
    RC_ASSERT(index < edge_count(owner));
    RC_ASSERT(distance(edge_of(owner, index), point_at(edge, 0.5)) < 1e-8);
  }
}

RC_GTEST_PROP(Offset, HoldsJustWhatIsWithinItsDistance, ()) {
  const Region a = any_region();
  const double by = any_distance();
  const Region result = offset(a, by);
  for (int i = 0; i < 50; ++i) {
    const Vec2 point{*rc::gen::inRange(-350, 350) * 0.1 + 0.0137,
                     *rc::gen::inRange(-350, 350) * 0.1 + 0.0271};
    const double away = distance_to_border(a, point);
    const double outside = side_of(a, point, 0) == Side::inside ? -away : away;
    if (std::fabs(outside - by) < 1e-6) continue;
    RC_ASSERT((side_of(result, point, 0) == Side::inside) == (outside < by));
  }
}

// From the middle of an edge to the nearest one of an owner.
double distance_to(const std::vector<Edge>& edges, std::uint32_t owner, const Edge& from) {
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges) {
    if (edge.owner == owner) least = std::min(least, distance(edge, point_at(from, 0.5)));
  }
  return least;
}

RC_GTEST_PROP(Offset, HasAllItsBorderAtItsDistance, ()) {
  const Contour shape = tangle(*corners(), 0);
  const Region a = region_of(shape);
  const double by = any_distance();
  RC_PRE(by != 0);
  for (const Edge& edge : edges_of(offset(a, by))) {
    for (const double share : {0.0, 0.3, 0.5, 0.9}) {
      const double away = distance_to_border(a, point_at(edge, share));
      RC_ASSERT(std::fabs(away - std::fabs(by)) < 1e-8);
    }
    RC_ASSERT(std::fabs(distance_to(edges_of(a), edge.owner, edge) - std::fabs(by)) < 1e-8);
  }
}

RC_GTEST_PROP(Offset, MakesValidRegions, ()) { expect_valid(offset(any_region(), any_distance())); }

RC_GTEST_PROP(Offset, OutAndInAgainHoldsTheOriginal, ()) {
  const Region a = any_region();
  const double by = std::fabs(any_distance());
  RC_ASSERT(std::fabs(area(subtract(a, offset(offset(a, by), -by)))) < 1e-5);
  RC_ASSERT(std::fabs(area(subtract(offset(offset(a, -by), by), a))) < 1e-5);
}

}  // namespace
}  // namespace kerf::contour
