// Outlines of inserts: directions, sizes and places of the ISO 1832 shapes.
#include "stock/tool/insert.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/contour/region.hpp"
#include "stock/tool/insert_code.hpp"
#include "tool_maker.hpp"

namespace kerf::stock {
namespace {

using contour::Contour;
using contour::Vec2;
using test::Said;
using test::tool_of;
using M = Measure;

constexpr double kPi = std::numbers::pi;

Tool turning(const std::string& insert, int tip = 3, std::string_view type = "turning") {
  Tool tool = tool_of(type, {{M::tip, tip}});
  tool.insert = insert;
  return tool;
}

/// Directions of the edges that cut, away from the nose, the main one first.
std::pair<Vec2, Vec2> edges_of(const Contour& outline, Vec2 nose) {
  std::vector<Vec2> found;
  for (std::size_t i = 0; i < contour::edge_count(outline); ++i) {
    const contour::Edge edge = contour::edge_of(outline, i);
    if (edge.bulge != 0 || edge.owner != owner(InsertPart::edge)) continue;
    const bool leads_away = length(edge.to - nose) > length(edge.from - nose);
    const Vec2 way = geometry::unit(edge.to - edge.from);
    found.push_back(leads_away ? way : -way);
  }
  EXPECT_EQ(found.size(), 2U);
  const bool in_order = geometry::cross(found[0], found[1]) < 0;
  return in_order ? std::pair(found[0], found[1]) : std::pair(found[1], found[0]);
}

void expect_near(Vec2 got, double u, double v, double tolerance = 1e-4) {
  EXPECT_NEAR(got.u, u, tolerance);
  EXPECT_NEAR(got.v, v, tolerance);
}

TEST(Insert, OfC80At95HasTheEdgesOfTheSpecification) {
  const Insert insert = insert_of(turning("CNMG120408"));
  const auto [main, minor] = edges_of(insert.outline, insert.nose_centre);
  expect_near(main, 0.0872, 0.9962);
  expect_near(minor, 0.9962, 0.0872);
  expect_near(insert.nose_centre, 0.8, 0.8, 1e-12);
  EXPECT_DOUBLE_EQ(insert.nose_radius, 0.8);
  EXPECT_TRUE(contour::is_counterclockwise(insert.outline));
}

TEST(Insert, TouchesTheImaginaryTipWithItsNose) {
  const contour::Box box = contour::extents(insert_of(turning("DCMT11T304")).outline);
  EXPECT_NEAR(box.low.u, 0, 1e-12);
  EXPECT_NEAR(box.low.v, 0, 1e-12);
}

// A body about its inscribed circle has the area of that circle's radius times half its outline;
// the nose takes away r² (cot(ε/2) − (π − ε)/2).
TEST(Insert, HasTheAreaOfItsShape) {
  const double rho = 6.35;
  const auto cot = [](double degrees) { return 1 / std::tan(degrees / 180 * kPi); };
  const auto nose = [&](double r, double angle) {
    return r * r * (cot(angle / 2) - (180 - angle) / 360 * kPi);
  };
  const auto area_of = [](const char* code) {
    return contour::area(insert_of(turning(code)).outline);
  };
  EXPECT_NEAR(area_of("CNMG120400"), 12.7 * 12.7 / std::sin(80 / 180.0 * kPi), 1e-9);
  EXPECT_NEAR(area_of("CNMG120408"), 12.7 * 12.7 / std::sin(80 / 180.0 * kPi) - nose(0.8, 80),
              1e-9);
  EXPECT_NEAR(area_of("TNMG220412"), 3 * rho * rho * cot(30) - nose(1.2, 60), 1e-9);
  EXPECT_NEAR(area_of("SNMG120408"), 12.7 * 12.7 - nose(0.8, 90), 1e-9);
  EXPECT_NEAR(area_of("WNMG080408"), 3 * rho * rho * (cot(40) + cot(80)) - nose(0.8, 80), 1e-9);
  EXPECT_NEAR(area_of("RCMT1204M0"), kPi * 36, 1e-9);
  for (const char* code : {"HNMG", "ONMG", "PNMG"}) {
    const Insert insert = insert_of(turning(code));
    const double sides = code[0] == 'H' ? 6 : code[0] == 'O' ? 8 : 5;
    const double whole = sides * rho * rho * std::tan(kPi / sides);
    EXPECT_NEAR(contour::area(insert.outline), whole - nose(0.4, 180 - 360 / sides), 1e-9) << code;
  }
}

TEST(Insert, IsMirroredByItsTipDirection) {
  const Contour base = insert_of(turning("DNMG150608")).outline;
  for (const auto& [tip, u, v] :
       {std::tuple(4, -1, 1), std::tuple(2, 1, -1), std::tuple(1, -1, -1)}) {
    const Insert insert = insert_of(turning("DNMG150608", tip));
    EXPECT_TRUE(contour::is_counterclockwise(insert.outline)) << tip;
    EXPECT_NEAR(contour::area(insert.outline), contour::area(base), 1e-9);
    for (const contour::Vertex& vertex : base.vertices) {
      const Vec2 point{u * vertex.point.u, v * vertex.point.v};
      EXPECT_LT(contour::distance(insert.outline, point), 1e-9) << tip;
    }
    expect_near(insert.nose_centre, u * 0.8, v * 0.8, 1e-12);
  }
}

// Vector from the centre of the nose to the tip, (Z, X): fanuc-dialect.md §11.2.
TEST(Insert, StandsOnItsTipAsTheTableOfDirectionsSays) {
  const double r = 0.8;
  const std::array<Vec2, 10> table = {
      {{0, 0}, {r, r}, {-r, r}, {-r, -r}, {r, -r}, {r, 0}, {0, r}, {-r, 0}, {0, -r}, {0, 0}}};
  for (int tip = 0; tip <= 9; ++tip) {
    const Insert insert = insert_of(turning("VBMT160408", tip));
    const Vec2 vector = table[static_cast<std::size_t>(tip)];
    expect_near(insert.nose_centre, -vector.u, -vector.v, 1e-12);
    EXPECT_NEAR(contour::distance(insert.outline, insert.nose_centre), r, 1e-9);
    if (tip < 5 || tip > 8) continue;
    const auto [main, minor] = edges_of(insert.outline, insert.nose_centre);
    const Vec2 middle = geometry::unit(main + minor);
    expect_near(middle, -vector.u / r, -vector.v / r, 1e-12);
    EXPECT_NEAR(geometry::dot(main, minor), std::cos(35 / 180.0 * kPi), 1e-12);
  }
}

TEST(Insert, OfABoringBarStandsUpwardsWhereNothingElseIsSaid) {
  Tool tool = tool_of("boring-bar", {{M::nose_radius, 0.4}});
  EXPECT_LT(insert_of(tool).nose_centre.v, 0);
  EXPECT_FALSE(insert_of(tool).holder);
  tool.measures.set(M::minimum_bore, 20);
  tool.measures.set(M::overhang, 60);
  tool.measures.set(M::holder_width, 16);
  ASSERT_EQ(objection(tool), "");
  const contour::Box bar = contour::extents(*insert_of(tool).holder);
  EXPECT_NEAR(bar.low.v, -20, 1e-12);
  EXPECT_NEAR(bar.high.v, -4, 1e-12);
  EXPECT_NEAR(bar.high.u, 60, 1e-12);
  EXPECT_NEAR(bar.low.u, contour::extents(insert_of(tool).outline).high.u, 1e-12);
  tool.measures.set(M::overhang, 5);
  EXPECT_NE(objection(tool).find("overhang, 5, is not more than"), std::string::npos);
}

TEST(Insert, OfAGrooveCoversItsWidthBehindItsReferenceCorner) {
  const auto box_of = [](std::string_view type, int tip) {
    const Insert insert = insert_of(
        tool_of(type, {{M::width, 3}, {M::tip, tip}, {M::flute_length, 12}, {M::stickout, 30}}));
    EXPECT_TRUE(contour::is_counterclockwise(insert.outline));
    return contour::extents(insert.outline);
  };
  const auto expect_box = [](const contour::Box& box, Vec2 low, Vec2 high) {
    expect_near(box.low, low.u, low.v, 1e-12);
    expect_near(box.high, high.u, high.v, 1e-12);
  };
  expect_box(box_of("grooving", 3), {0, 0}, {3, 30});
  expect_box(box_of("parting", 4), {-3, 0}, {0, 30});
  expect_box(box_of("grooving", 8), {-1.5, 0}, {1.5, 30});
  expect_box(box_of("grooving", 2), {0, -30}, {3, 0});
  expect_box(box_of("face-grooving", 3), {0, 0}, {30, 3});
  expect_box(box_of("face-grooving", 2), {0, -3}, {30, 0});
  expect_box(box_of("face-grooving", 7), {0, -1.5}, {30, 1.5});
}

TEST(Insert, OfAGrooveCutsAsFarAsItsFlutes) {
  const Tool tool =
      tool_of("grooving",
              {{M::width, 4}, {M::corner_radius, 0.5}, {M::flute_length, 12}, {M::stickout, 30}});
  const Insert insert = insert_of(tool);
  double cutting = 0;
  for (std::size_t i = 0; i < contour::edge_count(insert.outline); ++i) {
    const contour::Edge edge = contour::edge_of(insert.outline, i);
    if (edge.owner == owner(InsertPart::edge)) cutting += contour::length(edge);
  }
  EXPECT_NEAR(cutting, 3 + 2 * 11.5 + kPi * 0.5, 1e-12);
  EXPECT_NEAR(contour::area(insert.outline), 120 - 0.25 * (2 - kPi / 2), 1e-12);
  const Tool open = tool_of("parting", {{M::width, 4}});
  EXPECT_EQ(contour::extents(insert_of(open).outline).high.v, Insert::kEndless_mm);
}

TEST(Insert, OfAThreadIsAVOfOnePitch) {
  const Insert insert = insert_of(tool_of("threading", {{M::pitch, 2}}));
  const contour::Box box = contour::extents(insert.outline);
  EXPECT_NEAR(box.low.u, -1, 1e-12);
  EXPECT_NEAR(box.high.u, 1, 1e-12);
  EXPECT_NEAR(box.high.v, std::sqrt(3.0), 1e-12);
  EXPECT_EQ(objection(tool_of("threading", {{M::pitch, 1}, {M::nose_radius, 3}})),
            "nose_radius, 3, is larger than the thread");
}

TEST(InsertCode, IsReadByItsLettersAndDigits) {
  const auto code = read_insert_code("dcmt11t304-pf");
  ASSERT_TRUE(code);
  EXPECT_EQ(code->shape, 'D');
  EXPECT_EQ(code->measures.get(M::tip_angle), 55);
  EXPECT_EQ(code->measures.get(M::ic), 9.525);
  EXPECT_EQ(code->measures.get(M::nose_radius), 0.4);
  EXPECT_EQ(code->measures.get(M::kapr), 93);
  EXPECT_EQ(read_insert_code("RCMT0803M0")->measures.get(M::nose_radius), 4);
  EXPECT_EQ(read_insert_code("CNMG120400")->measures.get(M::nose_radius), 0);
  EXPECT_EQ(read_insert_code("CNMG")->measures.get(M::ic), std::nullopt);
}

TEST(InsertCode, OfNoInsertIsRefused) {
  for (const char* text : {"", "C", "CN8", "XNMG120408", "1204", "CNMGxx0408"}) {
    EXPECT_FALSE(read_insert_code(text)) << text;
  }
  Tool tool = tool_of("flat", {{M::diameter, 5}});
  tool.insert = "CNMG120408";
  EXPECT_EQ(objection(tool), "a tool of type flat has no insert");
}

TEST(InsertCode, CountsLessThanWhatIsSaid) {
  Tool tool = turning("CNMG120408");
  tool.measures.set(M::ic, 40);
  tool.measures.set(M::nose_radius, 0);
  const Contour outline = insert_of(tool).outline;
  EXPECT_NEAR(contour::area(outline), 1600 / std::sin(80 / 180.0 * kPi), 1e-9);
}

}  // namespace
}  // namespace kerf::stock
