#include "geometry/contour/relation.hpp"

#include <gtest/gtest.h>

#include "geometry/contour/boolean.hpp"
#include "shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names

Region square(double low, double high) { return region_of(rectangle(low, low, high, high)); }

Region channel() {
  return region_of(closed({{{0, 0}},
                           {{60, 0}},
                           {{60, 40}},
                           {{40, 40}},
                           {{40, 20}},
                           {{20, 20}},
                           {{20, 40}},
                           {{0, 40}}}));
}

struct Row {
  const char* what;
  Region a;
  Region b;
  Related expected;
};

std::vector<Row> rows() {
  const auto box = [](double x0, double y0, double x1, double y1) {
    return region_of(rectangle(x0, y0, x1, y1));
  };
  return {
      {"a square around a small one", square(0, 40), square(10, 20), {Relation::contains, false}},
      {"the small one in it", square(10, 20), square(0, 40), {Relation::inside, false}},
      {"circles apart", disc({0, 0}, 20), disc({40, 0}, 5), {Relation::disjoint, false}},
      {"circles that cross", disc({0, 0}, 20), disc({18, 0}, 10), {Relation::overlaps, true}},
      {"a bar across both arms", channel(), box(5, 25, 55, 35), {Relation::overlaps, true}},
      {"a square in the mouth", channel(), box(25, 25, 35, 35), {Relation::disjoint, false}},
      {"a bar in an arm", channel(), box(5, 5, 15, 35), {Relation::contains, false}},
      {"a thin bar", square(0, 40), box(-10, 19, 50, 21), {Relation::overlaps, true}},
      {"a bar beside", square(0, 40), box(50, -20, 60, 60), {Relation::disjoint, false}},
      {"the same from another vertex",
       square(0, 40),
       region_of(closed({{{40, 40}}, {{0, 40}}, {{0, 0}}, {{20, 0}}, {{40, 0}}})),
       {Relation::equal, true}},
      {"squares with a common border",
       square(0, 40),
       box(40, 10, 50, 20),
       {Relation::disjoint, true}},
      {"squares with a common corner", square(0, 40), square(40, 50), {Relation::disjoint, true}},
      {"circles that touch outside",
       disc({0, 0}, 20),
       disc({25, 0}, 5),
       {Relation::disjoint, true}},
      {"circles that touch inside",
       disc({0, 0}, 20),
       disc({0.6 * 15, 0.8 * 15}, 5),
       {Relation::contains, true}},
      {"a peg that fits its hole",
       subtract(disc({0, 0}, 20), disc({3, 0}, 10)),
       disc({3, 0}, 10),
       {Relation::disjoint, true}},
      {"nothing and something", Region{}, square(0, 1), {Relation::disjoint, false}},
      {"nothing and nothing", Region{}, Region{}, {Relation::equal, false}}};
}

TEST(Relation, GoesByAreasAndTellsWhetherBordersMeet) {
  for (const Row& row : rows()) {
    const Related found = relation(row.a, row.b);
    EXPECT_EQ(static_cast<int>(found.relation), static_cast<int>(row.expected.relation))
        << row.what;
    EXPECT_EQ(found.touches, row.expected.touches) << row.what;
  }
}

TEST(Relation, IsTheOppositeTheOtherWayRound) {
  for (const Row& row : rows()) {
    Related opposite = row.expected;
    if (row.expected.relation == Relation::contains) opposite.relation = Relation::inside;
    if (row.expected.relation == Relation::inside) opposite.relation = Relation::contains;
    EXPECT_EQ(relation(row.b, row.a), opposite) << row.what;
  }
}

}  // namespace
}  // namespace kerf::contour
