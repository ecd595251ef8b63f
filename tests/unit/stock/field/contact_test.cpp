// What must and must not be told (stock.md §5; §9, verdicts 1, 2, 3, 5, 6 and 8).
#include <gtest/gtest.h>

#include "stock/field/field_jobs.hpp"

namespace kerf::stock::field {
namespace {

const Bounds kBox{{0, 0, -40}, {70, 40, 0}};

const Contact& met(const Job& job, ToolPart part) { return job.last().contacts[index(part)]; }
bool is_clear(const Job& job) {
  for (std::size_t i = 0; i < kToolParts; ++i) {
    if (job.last().contacts[i].is_one()) return false;
  }
  return true;
}

class Contacts : public testing::TestWithParam<double> {};

TEST_P(Contacts, NoneOfARapidAlongTheFloorThatWasCut) {
  Job job(kBox, GetParam(), flat(10));
  job.at({10, 20, 5}).to({10, 20, -5}).to({60, 20, -5});
  job.rapid({10, 20, -5});
  EXPECT_TRUE(is_clear(job));
  EXPECT_EQ(job.last().removed, Exact());
  job.rapid({10, 20, 5});
  EXPECT_TRUE(is_clear(job));
}

TEST_P(Contacts, OfARapidBesideTheSlot) {
  Job job(kBox, GetParam(), flat(10));
  job.at({10, 20, 5}).to({10, 20, -5}).to({60, 20, -5});
  job.at({60, 21, -5}).rapid({10, 21, -5});
  EXPECT_NEAR(met(job, ToolPart::edge).depth_mm, 5, 1e-5);
  EXPECT_NEAR(met(job, ToolPart::edge).at.z, -5, 1e-5);
  EXPECT_GT(met(job, ToolPart::edge).at.y, 20);
  EXPECT_NEAR(met(job, ToolPart::edge).volume.value(), job.last().removed.value(), 1e-6);
  // 1 mm of the wall over 50 mm, and what is before the rounded ends of the slot.
  EXPECT_NEAR(job.last().removed.value(), 5 * 50 * 1 + 5 * 10, 15);
  job.rapid({60, 21, -5});
  EXPECT_TRUE(is_clear(job)) << "what was met is gone";
}

TEST_P(Contacts, NoneOfRapidsInAHoleThatIsDrilledInSteps) {
  Job job(kBox, GetParam(), cone(8, 118, 0, 60));
  job.at({30, 20, 2});
  for (double z = -6; z >= -24; z -= 6) {
    job.rapid({30, 20, z < -6 ? z + 6.5 : 2});
    EXPECT_TRUE(is_clear(job)) << z;
    job.to({30, 20, z});
    EXPECT_TRUE(is_clear(job)) << z;
    job.rapid({30, 20, 2});
    EXPECT_TRUE(is_clear(job)) << z;
  }
}

TEST_P(Contacts, NoneOfARapidAtTheHeightOfTheStockNorBesideIt) {
  Job job(kBox, GetParam(), ball(6));
  job.at({-10, 20, 0}).rapid({80, 20, 0});
  EXPECT_TRUE(is_clear(job));
  job.at({-3, -10, -10}).rapid({-3, 50, -10});
  EXPECT_TRUE(is_clear(job));
}

TEST_P(Contacts, OfFlutesThatAreTooShortWhereTheToolGoesSideways) {
  Job job(kBox, GetParam(), with(flat(10, 20), ToolPart::flank, 10, 60));
  job.at({10, 20, 5}).to({10, 20, -26});
  EXPECT_TRUE(is_clear(job)) << "at the plunge";
  job.to({60, 20, -26});
  EXPECT_NEAR(met(job, ToolPart::flank).depth_mm, 6, 1e-4);
  EXPECT_NEAR(met(job, ToolPart::flank).at.z, -6, 1e-4);
  EXPECT_FALSE(met(job, ToolPart::edge).is_one());
}

TEST_P(Contacts, NoneOfShortFlutesInTwoPasses) {
  Job job(kBox, GetParam(), with(flat(10, 20), ToolPart::flank, 10, 60));
  job.at({10, 20, 5}).to({10, 20, -15}).to({60, 20, -15});
  job.at({10, 20, -15}).to({10, 20, -26}).to({60, 20, -26});
  EXPECT_TRUE(job.met_nothing());
}

TEST_P(Contacts, OfAShankThatIsWiderThanItsEdges) {
  Job job(kBox, GetParam(), with(flat(10, 20), ToolPart::shank, 12, 60));
  job.at({10, 20, 5}).to({10, 20, -15}).to({60, 20, -15});
  EXPECT_TRUE(job.met_nothing());
  job.at({10, 20, -15}).to({10, 20, -26}).to({60, 20, -26});
  EXPECT_NEAR(met(job, ToolPart::shank).depth_mm, 6, 1e-4);
}

TEST_P(Contacts, OfAHolderWithTheDepthItHas) {
  const Body shank = with(flat(10, 20), ToolPart::flank, 10, 10);
  Job job(kBox, GetParam(), with(shank, ToolPart::holder, 40, 40));
  job.at({35, 20, 5}).to({35, 20, -35});
  EXPECT_NEAR(met(job, ToolPart::holder).depth_mm, 5, 1e-4);
  EXPECT_NEAR(met(job, ToolPart::holder).at.z, -5, 1e-4);
  const Body longer = with(with(flat(10, 20), ToolPart::flank, 10, 20), ToolPart::holder, 40, 40);
  Job free(kBox, GetParam(), longer);
  free.at({35, 20, 5}).to({35, 20, -35});
  EXPECT_TRUE(is_clear(free));
}

TEST_P(Contacts, BeginAtTwiceTheTolerance) {
  for (const double depth : {0.005, 0.015, 0.03}) {
    Job job(kBox, GetParam(), flat(10));
    job.at({-10, 20, -depth}).rapid({80, 20, -depth});
    EXPECT_EQ(!is_clear(job), depth > 0.02) << depth;
  }
}

TEST_P(Contacts, OfAProbeInAFeed) {
  Body probe = ball(4);
  probe.cuts = false;
  Job job(kBox, GetParam(), probe);
  job.at({35, 20, 5}).to({35, 20, -1});
  EXPECT_NEAR(met(job, ToolPart::edge).depth_mm, 1, 0.02);
}

TEST_P(Contacts, OfACoreAreOfAPlungeAndNotOfAFace) {
  Body mill = flat(40, 8);
  mill.core_mm = 12;
  Job down(kBox, GetParam(), mill);
  down.at({35, 20, 5}).to({35, 20, -1});
  EXPECT_NEAR(down.last().core.value(), 12 * 12 * 3.14159265 * 1, 12 * 12 * 3.14159265 * 0.01);
  down.to({45, 20, -1});
  EXPECT_NEAR(down.last().core.value(), 0, 1e-9);
  Job beside(kBox, GetParam(), mill);
  beside.at({-30, 20, 5}).to({-30, 20, -1}).to({100, 20, -1});
  EXPECT_EQ(beside.last().core, Exact());
  // A ramp: while it is over a column the core comes down by the slope times its chord.
  Job ramp(kBox, GetParam(), mill);
  ramp.at({-30, 20, 0}).to({100, 20, -13});
  EXPECT_GT(ramp.last().core.value(), 100);
  Job up(kBox, GetParam(), mill);
  up.at({-30, 20, -13}).to({100, 20, 0});
  EXPECT_EQ(up.last().core, Exact());
}

INSTANTIATE_TEST_SUITE_P(Cells, Contacts, testing::Values(0.1, 0.25));

}  // namespace
}  // namespace kerf::stock::field
