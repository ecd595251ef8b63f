// Verdicts of stock.md §9.
#include "mill.hpp"

namespace kerf::stock::dexel::test {
namespace {

const Bounds kSlotStock{{0, 0, -20}, {70, 40, 0}};

const Contact& met(const Outcome& outcome, ToolPart part) { return outcome.contacts[index(part)]; }

/// Edges to 20 mm, above them a flank of the same width or a shank.
Body end_mill(double d, double flutes, double shank = 0) {
  Outline outline;
  outline.to(d / 2, 0).to(d / 2, flutes);
  if (shank == 0) return outline.as(ToolPart::flank).to(d / 2, kTall).body();
  return outline.as(ToolPart::shank).to(shank / 2, flutes).to(shank / 2, kTall).body();
}
Body held(double d, double stickout, double holder) {
  return Outline()
      .to(d / 2, 0)
      .to(d / 2, stickout)
      .as(ToolPart::holder)
      .to(holder / 2, stickout)
      .to(holder / 2, kTall)
      .body();
}

class DexelContacts : public testing::TestWithParam<double> {
 protected:
  [[nodiscard]] static double cell() { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Cell, DexelContacts, testing::Values(0.2, 0.37));

TEST_P(DexelContacts, HaveNoneWhoReturnsAlongItsOwnSlot) {
  Mill mill(kSlotStock, cell());
  mill.tool(flat(10)).at({10, 20, 5}).line({10, 20, -5}).line({60, 20, -5});
  mill.rapid({10, 20, -5}).rapid({10, 20, 5}).run();
  EXPECT_FALSE(mill.has_contacts());
}

TEST_P(DexelContacts, AreMetOneMillimetreBesideTheSlot) {
  Mill mill(kSlotStock, cell());
  mill.tool(flat(10)).at({10, 20, 5}).line({10, 20, -5}).line({60, 20, -5});
  mill.rapid({60, 20, 5}).rapid({60, 21, 5});
  mill.run();
  EXPECT_FALSE(mill.has_contacts());
  mill.at({60, 21, -5}).rapid({10, 21, -5}).run();
  const Contact& contact = met(mill.last(), ToolPart::edge);
  ASSERT_TRUE(contact.is_one());
  EXPECT_NEAR(contact.depth_mm, 5, 1e-5);
  EXPECT_NEAR(contact.at.z, -5, 1e-5);
  EXPECT_GT(contact.at.y, 20);
  // As wide as the slot is long, 1 mm, 5 deep.
  EXPECT_NEAR(contact.volume.value(), 60 * 1 * 5, 60 * 5 * cell());
}

TEST_P(DexelContacts, HaveNoneWhoPecks) {
  Mill mill(kSlotStock, cell());
  mill.tool(pointed(10, 59)).at({30, 20, 2});
  for (const double z : {-4.0, -8.0, -12.0}) {
    mill.line({30, 20, z}).rapid({30, 20, 2}).rapid({30, 20, z + 0.5});
  }
  mill.rapid({30, 20, 2}).run();
  EXPECT_FALSE(mill.has_contacts());
}

TEST_P(DexelContacts, HaveNoneWhoGoesAtTheHeightOfTheStockOrAlongItsSide) {
  Mill mill(kSlotStock, cell());
  mill.tool(flat(10)).at({-20, 20, 0}).rapid({90, 20, 0}).rapid({90, -5, 0});
  mill.rapid({90, -5, -10}).rapid({-20, -5, -10}).run();
  EXPECT_FALSE(mill.has_contacts());
}

TEST_P(DexelContacts, OfTheFlankAreMetSidewaysAndNotInThePlunge) {
  Mill mill({{0, 0, -40}, {70, 40, 0}}, cell());
  mill.tool(end_mill(10, 20)).at({20, 20, 5}).line({20, 20, -26}).run();
  EXPECT_FALSE(mill.has_contacts());
  mill.line({50, 20, -26}).run();
  ASSERT_TRUE(met(mill.last(), ToolPart::flank).is_one());
  EXPECT_NEAR(met(mill.last(), ToolPart::flank).depth_mm, 6, 1e-5);
  EXPECT_FALSE(met(mill.last(), ToolPart::shank).is_one());
}

TEST_P(DexelContacts, OfTheFlankAreNoneInTwoLevels) {
  for (const bool has_shank : {false, true}) {
    Mill mill({{0, 0, -40}, {70, 40, 0}}, cell());
    mill.tool(end_mill(10, 20, has_shank ? 12 : 0)).at({20, 20, 5});
    for (const double z : {-15.0, -26.0}) {
      mill.line({20, 20, z}).line({50, 20, z}).rapid({50, 20, 5}).rapid({20, 20, 5});
    }
    mill.run();
    EXPECT_EQ(mill.has_contacts(), has_shank);
    const Contact& shank = met(mill.outcomes[5], ToolPart::shank);
    EXPECT_EQ(shank.is_one(), has_shank);
    EXPECT_NEAR(shank.depth_mm, has_shank ? 6 : 0, 1e-5);
  }
}

TEST_P(DexelContacts, OfTheHolderAreAsDeepAsItGoesIn) {
  for (const double stickout : {30.0, 40.0}) {
    Mill mill({{-30, -30, -50}, {30, 30, 0}}, std::max(0.25, cell()));
    mill.tool(held(10, stickout, 40)).at({0, 0, 5}).line({0, 0, -35}).run();
    const Contact& holder = met(mill.last(), ToolPart::holder);
    EXPECT_EQ(holder.is_one(), stickout == 30);
    if (holder.is_one()) {
      EXPECT_NEAR(holder.depth_mm, 5, 1e-5);
      const double ring = pi * (20 * 20 - 5 * 5) * 5;
      EXPECT_NEAR(holder.volume.value(), ring, ring * 0.03);
    }
  }
}

TEST_P(DexelContacts, OfAHolderThatOnlyItsSideMeetsAreFoundByTheOtherDexels) {
  // 0.03 mm into a wall: no column of the grid along the tool may be in it.
  Mill mill({{0, 0, -20}, {20, 20, 0}}, cell());
  mill.tool(flat(10)).at({-4.97, -20, -10}).rapid({-4.97, 40, -10}).run();
  const Contact& contact = met(mill.last(), ToolPart::edge);
  EXPECT_TRUE(contact.is_one());
  mill.at({-4.992, 40, -15}).rapid({-4.992, -20, -15}).run();
  EXPECT_FALSE(met(mill.last(), ToolPart::edge).is_one());
}

TEST_P(DexelContacts, OfAToolThatTurnsAreThoseOfItsPoses) {
  Mill mill({{-15, -15, -15}, {15, 15, 0}}, std::max(0.25, cell()));
  mill.tool(held(6, 12, 20)).at({0, 0, 5}).line({0, 0, -10}).run();
  EXPECT_FALSE(mill.has_contacts());
  // The rim of its holder stands at 12 cos phi - 10 sin phi above the tip.
  mill.turn({0, 0, -10}, {std::sin(0.15), 0, std::cos(0.15)}).run();
  EXPECT_FALSE(met(mill.last(), ToolPart::holder).is_one());
  mill.turn({0, 0, -10}, {std::sin(0.35), 0, std::cos(0.35)}).run();
  const Contact& holder = met(mill.last(), ToolPart::holder);
  ASSERT_TRUE(holder.is_one());
  const double deep = 10 - 12 * std::cos(0.35) + 10 * std::sin(0.35);
  EXPECT_NEAR(holder.depth_mm, deep, 0.35);
}

TEST_P(DexelContacts, OfAProbeAreItsEdgesToo) {
  Body probe = ball(4);
  probe.cuts = false;
  Mill mill(kSlotStock, cell());
  mill.tool(probe).at({30, 20, 10}).line({30, 20, 0}).run();
  EXPECT_FALSE(mill.has_contacts());
  mill.line({30, 20, -1}).run();
  EXPECT_TRUE(met(mill.last(), ToolPart::edge).is_one());
}

TEST_P(DexelContacts, AreToldOnceForTheyAreRemoved) {
  Mill mill(kSlotStock, cell());
  mill.tool(flat(10)).at({-20, 20, -3}).rapid({90, 20, -3}).run();
  EXPECT_TRUE(met(mill.last(), ToolPart::edge).is_one());
  EXPECT_NEAR(mill.last().removed.value(), 3 * 10 * 70, 3 * 70 * cell());
  mill.rapid({-20, 20, -3}).run();
  EXPECT_FALSE(met(mill.last(), ToolPart::edge).is_one());
  EXPECT_EQ(mill.last().removed.value(), 0);
}

TEST_P(DexelContacts, OfTheCoreAreThoseOfAPlunge) {
  Body face = flat(40);
  face.core_mm = 12;
  Mill mill({{0, 0, -20}, {80, 80, 0}}, std::max(0.25, cell()));
  mill.tool(face).at({40, 40, 5}).line({40, 40, -2}).run();
  const double core = pi * 12 * 12 * 2;
  EXPECT_NEAR(mill.last().core.value(), core, 0.02 * core);
  Mill beside({{0, 0, -20}, {80, 80, 0}}, std::max(0.25, cell()));
  beside.tool(face).at({-30, 40, 5}).line({-30, 40, -2}).line({110, 40, -2}).run();
  EXPECT_EQ(beside.last().core.value(), 0);
  EXPECT_GT(beside.last().removed.value(), 40 * 80 * 2 * 0.98);
}

TEST_P(DexelContacts, OfTheCoreInARampAreASlantedCylinder) {
  Body face = flat(20);
  face.core_mm = 5;
  Mill mill({{0, 0, -20}, {80, 40, 0}}, std::max(0.25, cell()));
  mill.tool(face).at({20, 20, 0}).line({60, 20, -4}).run();
  const double core = pi * 5 * 5 * 4;
  EXPECT_NEAR(mill.last().core.value(), core, 0.05 * core);
}

TEST_P(DexelContacts, AcrossTheWayStandOnTheirSide) {
  Mill mill(kSlotStock, cell());
  // The stock lies to the left of the feed, 2 mm of the tool in it.
  mill.tool(flat(10)).at({-20, -3, -5}).line({90, -3, -5}).run();
  const Outcome& cut = mill.last();
  double left = 0;
  for (std::size_t i = 0; i < Outcome::kBins; ++i) {
    const double s = -5 + 10 * (static_cast<double>(i) + 0.5) / Outcome::kBins;
    if (s < 3 - 10.0 / Outcome::kBins) {
      EXPECT_EQ(cut.across[i].value(), 0) << s;
    }
    left += cut.across[i].value();
  }
  EXPECT_NEAR(left, cut.removed.value(), 1e-6);
  EXPECT_NEAR(left, 70 * 2 * 5, 70 * 5 * cell());
}

TEST_P(DexelContacts, FirstOfAProbeIsWhereItsBallTouches) {
  Mill mill(kSlotStock, cell());
  const auto t = [&](Vec3 from, Vec3 to) {
    const Vec3 up{0, 0, 2};  // ways of the tip, a ball of 4 mm
    return mill.model.first_touch({{from + up, to + up}, 2});
  };
  const double dent = 1e-5;  // float32
  ASSERT_TRUE(t({30, 20, 10}, {30, 20, -10}));
  EXPECT_NEAR(*t({30, 20, 10}, {30, 20, -10}), 0.5, dent / 20);
  EXPECT_NEAR(*t({-20, 20, -10}, {20, 20, -10}), 18.0 / 40, dent / 40);
  EXPECT_FALSE(t({-20, 20, 1}, {90, 20, 1}));
  EXPECT_EQ(*t({30, 20, -5}, {30, 20, -6}), 0);
}

}  // namespace
}  // namespace kerf::stock::dexel::test
