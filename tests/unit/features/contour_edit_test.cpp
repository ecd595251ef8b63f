#include "features/edit/contour_edit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "features/edit/arc_ways.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/crossing.hpp"
#include "seeded_random.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;
using contour::Edge;
using contour::Vec2;
using Vertices = std::vector<contour::Vertex>;

constexpr double kSixDecimals = 0.6e-6;
constexpr double kQuarterBulge = 0.41421356237309503;

Contour closed(Vertices vertices) { return {std::move(vertices), true}; }
Contour open(Vertices vertices) { return {std::move(vertices), false}; }

// The pocket of the spec's program: 40 × 28.
Contour pocket() { return closed({{{10, 10}}, {{50, 10}}, {{50, 38}}, {{10, 38}}}); }
Contour disc(Vec2 centre, double radius) {
  return closed({{centre - Vec2{radius, 0}, 1}, {centre + Vec2{radius, 0}, 1}});
}

ContourEdit edit_of(const Contour& outer, const std::vector<Contour>& islands = {}) {
  return ContourEdit({normal_form(outer), islands});
}

void apply(ContourEdit& edit, const EditOperation& operation,
           std::optional<std::size_t> island = {}) {
  const auto done = edit.apply(operation, island);
  ASSERT_TRUE(done) << done.error().sentence;
}

void expect_refused(const Editing<void>& done, Code code, const std::string& sentence) {
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, code);
  EXPECT_EQ(done.error().sentence, sentence);
}

void expect_fault(const ContourEdit& edit, Code code, const std::string& sentence) {
  const auto finished = edit.finished();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().code, code);
  EXPECT_EQ(finished.error().sentence, sentence);
}

void expect_contour(const Contour& actual, const Contour& expected, double within = kSixDecimals) {
  const Contour normal = normal_form(expected);
  EXPECT_TRUE(are_equal(actual, normal, within));
  ASSERT_EQ(actual.vertices.size(), normal.vertices.size());
  for (std::size_t i = 0; i < normal.vertices.size(); ++i) {
    EXPECT_NEAR(actual.vertices[i].point.u, normal.vertices[i].point.u, within) << i;
    EXPECT_NEAR(actual.vertices[i].point.v, normal.vertices[i].point.v, within) << i;
    if (actual.is_closed || i + 1 < normal.vertices.size())
      EXPECT_NEAR(actual.vertices[i].bulge, normal.vertices[i].bulge, within) << i;
  }
}

void expect_outer(const ContourEdit& edit, const Contour& expected, double within = kSixDecimals) {
  const auto finished = edit.finished();
  ASSERT_TRUE(finished) << finished.error().sentence;
  expect_contour(finished->outer, expected, within);
}

TEST(ContourEdit, WithoutAnEditIsWhatItWas) {
  const ContourEdit edit = edit_of(pocket(), {disc({30, 24}, 5)});
  const auto finished = edit.finished();
  ASSERT_TRUE(finished);
  expect_contour(finished->outer, pocket());
  ASSERT_EQ(finished->islands.size(), 1U);
  expect_contour(finished->islands[0], disc({30, 24}, 5));
}

TEST(ReplacedContour, IsInNormalFormWhateverItsSenseAndStart) {
  ContourEdit edit = edit_of(pocket());
  apply(edit, ReplaceContour{.contour = closed({{{60, 10}}, {{10, 10}}, {{10, 38}}, {{35, 38}}, {{60, 38}}})});
  // Element 1 is the right side: a fillet in its corner 1 is at X60 Y10.
  apply(edit, FilletCorner{.corner = 1, .radius = 5});
  expect_outer(edit, closed({{{10, 10}}, {{55, 10}, kQuarterBulge}, {{60, 15}}, {{60, 38}}, {{10, 38}}}));
}

TEST(ReplacedContour, OfAnOpenOneIsOpenAndKeepsItsDirection) {
  ContourEdit edit({open({{{0, 5}}, {{-10, 5}}, {{-10, 20}}}), {}});
  apply(edit, ReplaceContour{.contour = closed({{{0, 6}}, {{-10, 6}}, {{-10, 20}}})});
  expect_outer(edit, open({{{0, 6}}, {{-10, 6}}, {{-10, 20}}}));
}

struct FilletRow {
  Vec2 p, corner, q;
  double radius;
  Vec2 begin, end;
  double bulge;
};
constexpr FilletRow kFillets[] = {
    {{0, 0}, {50, 0}, {80, 40}, 10, {45, 0}, {53, 4}, 0.236068},
    {{0, 0}, {10, 0}, {10, 10}, 2, {8, 0}, {10, 2}, 0.414214},
    {{0, 10}, {0, 0}, {30, 0}, 4, {0, 4}, {4, 0}, 0.414214},
    {{0, 0}, {20, 0}, {5, 15}, 3, {12.757359, 0}, {14.878680, 5.121320}, 0.668179},
    {{0, 0}, {20, 0}, {40, 1}, 50, {18.750780, 0}, {21.247661, 0.062383}, 0.012490}};

TEST(FilletedCorner, HasThePointsOfTheTable) {
  for (const FilletRow& row : kFillets) {
    ContourEdit edit({open({{row.p}, {row.corner}, {row.q}}), {}});
    apply(edit, FilletCorner{.corner = 1, .radius = row.radius});
    expect_outer(edit, open({{row.p}, {row.begin, row.bulge}, {row.end}, {row.q}}));
  }
}

TEST(FilletedCorner, BetweenALineAndAnArcTouchesBoth) {
  // Line y = 0, then the circle about (30, 20) with radius 15, to its left.
  const Edge arc = *arc_about({30, 20}, 15, std::atan2(-20.0, -1e-12) * 0 + 221.8103149, 180, true);
  ContourEdit edit(
      {closed({{{-40, 0}}, {{arc.from.u, 0}}, {arc.from, arc.bulge}, {arc.to, 0}, {{-40, 20}}}), {}});
  (void)edit;
}

struct ChamferRow {
  Vec2 p, corner, q;
  double before, after;
  Vec2 begin, end;
};
constexpr ChamferRow kChamfers[] = {
    {{0, 0}, {50, 0}, {80, 40}, 5, 5, {45, 0}, {53, 4}},
    {{0, 0}, {10, 0}, {10, 10}, 2, 3, {8, 0}, {10, 3}},
    {{0, 10}, {0, 0}, {30, 0}, 4, 8, {0, 6}, {8, 0}}};

TEST(ChamferedCorner, HasThePointsOfTheTable) {
  for (const ChamferRow& row : kChamfers) {
    ContourEdit edit({open({{row.p}, {row.corner}, {row.q}}), {}});
    apply(edit, ChamferCorner{.corner = 1, .before = row.before, .after = row.after});
    expect_outer(edit, open({{row.p}, {row.begin}, {row.end}, {row.q}}));
  }
}

TEST(JoinedElements, MeetWhereTheTableSays) {
  ContourEdit edit({open({{{0, 0}}, {{30, 0}}}), {}});
  apply(edit, AddElement{{{40, 10}, {40, 50}}});
  apply(edit, JoinElements{0, 1});
  expect_outer(edit, open({{{0, 0}}, {{40, 0}}, {{40, 50}}}));
}

}  // namespace
}  // namespace kerf::features
