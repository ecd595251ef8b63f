#include "features/literal/scan_lines.hpp"

#include <gtest/gtest.h>

#include "geometry/contour/relation.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Relation;

Contour box(double x0, double y0, double x1, double y1) {
  return {{{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}}, true};
}
Contour circle(double x, double y, double radius) {
  return {{{{x - radius, y}, 1}, {{x + radius, y}, 1}}, true};
}
Contour channel() {
  return {
      {{{0, 0}}, {{60, 0}}, {{60, 40}}, {{40, 40}}, {{40, 20}}, {{20, 20}}, {{20, 40}}, {{0, 40}}},
      true};
}

struct Case {
  const char* name;
  Contour first;
  Contour second;
  ScanRelation seen;
  Relation exact;
};

// Where both differ the rule of the lines is wrong, and that is why it decides nothing.
TEST(ScanLines, SeeWhatTheSourceSaysAndTheExactRelationMayDiffer) {
  const Case cases[] = {
      {"square in square", box(0, 0, 40, 40), box(10, 10, 20, 20), ScanRelation::contains,
       Relation::contains},
      {"square round square", box(10, 10, 20, 20), box(0, 0, 40, 40), ScanRelation::none,
       Relation::inside},
      {"circles apart", circle(0, 0, 20), circle(40, 0, 5), ScanRelation::none, Relation::disjoint},
      {"circles that cross", circle(0, 0, 20), circle(18, 0, 10), ScanRelation::partial,
       Relation::overlaps},
      {"bar across both arms", channel(), box(5, 25, 55, 35), ScanRelation::partial,
       Relation::overlaps},
      {"square in the mouth", channel(), box(25, 25, 35, 35), ScanRelation::none,
       Relation::disjoint},
      {"square in an arm", channel(), box(5, 5, 15, 35), ScanRelation::contains,
       Relation::contains},
      {"thin bar between the lines", box(0, 0, 40, 40), box(-10, 19, 50, 21),
       ScanRelation::contains, Relation::overlaps},
      {"square beside", box(0, 0, 40, 40), box(50, -20, 60, 60), ScanRelation::none,
       Relation::disjoint},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    EXPECT_EQ(scan_relation(one.first, one.second), one.seen);
    const auto exact =
        contour::relation(contour::Region{{one.first}}, contour::Region{{one.second}});
    EXPECT_EQ(exact.relation, one.exact);
  }
}

TEST(ScanLines, ALineThroughTheEndOfAnEdgeDoesNotCount) {
  // One line each way, through the middle, where both have corners.
  const Contour diamond{{{{-10, 0}}, {{0, -10}}, {{10, 0}}, {{0, 10}}}, true};
  const Contour small{{{{-5, 0}}, {{0, -5}}, {{5, 0}}, {{0, 5}}}, true};
  EXPECT_EQ(scan_relation(diamond, small, 1), ScanRelation::undecided);
  EXPECT_EQ(scan_relation(diamond, small, 2), ScanRelation::undecided);  // at ±5: corners again
  EXPECT_EQ(scan_relation(diamond, small, 16), ScanRelation::contains);
}

}  // namespace
}  // namespace kerf::features
