// Energies of cuts: against P / v and the time that a spot takes from rest.
#include <gtest/gtest.h>

#include <cmath>

#include "output/picture/internal/energy_of_cut.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kPower_w = 60, kSpot_mm = 0.1, kPeriod_s = 0.001;

machine::LaserSettings laser() {
  machine::LaserSettings settings;
  settings.max_power_w = kPower_w;
  settings.spot_mm = kSpot_mm;
  return settings;
}

motion::Mark mark(float percent, std::uint32_t line = 1) {
  motion::Mark mark;
  mark.power_percent = percent;
  mark.block.line = line;
  return mark;
}

double run(EnergyOfCut& energy, double way_mm, int periods, const motion::Mark& mark) {
  double last = 0;
  for (int i = 0; i < periods; ++i)
    last = energy.take({way_mm, kPeriod_s, mark, mark.power_percent});
  return last;
}

TEST(EnergyOfCut, IsPowerBySpeedWhereTheSpeedIsConstant) {
  for (const double speed_mm_s : {0.5, 7.0, 100.0, 450.0}) {
    EnergyOfCut energy(laser());
    const double wanted = 0.8 * kPower_w / speed_mm_s;
    EXPECT_NEAR(run(energy, speed_mm_s * kPeriod_s, 2000, mark(80)), wanted, 0.02 * wanted);
    EXPECT_NEAR(energy.median(), wanted, 1e-9 * wanted) << speed_mm_s;
    EXPECT_NEAR(energy.most(), wanted, 0.02 * wanted) << speed_mm_s;
  }
}

TEST(EnergyOfCut, OfABeamThatRestsIsWhatItsSpotGets) {
  EnergyOfCut energy(laser());
  EXPECT_NEAR(run(energy, 0, 500, mark(50)), 0.5 * kPower_w * 0.5 / kSpot_mm, 1e-9);
}

TEST(EnergyOfCut, FromRestIsThatOfTheTimeOfOneSpot) {
  constexpr double kAcceleration = 3000;
  EnergyOfCut energy(laser());
  double before = 0;
  for (int i = 1; i <= 30; ++i) {
    const double way = kAcceleration * std::pow(i * kPeriod_s, 2) / 2;
    static_cast<void>(energy.take({way - before, kPeriod_s, mark(80), 80}));
    before = way;
  }
  const double wanted = 0.8 * kPower_w * std::sqrt(2 * kSpot_mm / kAcceleration) / kSpot_mm;
  EXPECT_NEAR(energy.most(), wanted, 0.12 * wanted);  // whole periods
}

TEST(EnergyOfCut, BeginsAnewWhereTheBeamGoesOn) {
  EnergyOfCut energy(laser());
  run(energy, 0.001, 500, mark(100));
  EXPECT_EQ(run(energy, 0.1, 1, mark(0)), 0);
  EXPECT_FALSE(energy.is_drawn(mark(0)));
  EXPECT_NEAR(run(energy, 0.1, 1, mark(100)), 0.6, 1e-9);
}

TEST(EnergyOfCut, NamesTheLineOfTheMost) {
  EnergyOfCut energy(laser());
  run(energy, 0.1, 10, mark(50, 7));
  run(energy, 0.1, 10, mark(90, 8));
  run(energy, 0.1, 10, mark(20, 9));
  EXPECT_EQ(energy.line_of_most(), 8U);
  EXPECT_NEAR(energy.burn(), 2 * 0.3, 1e-9);
}

TEST(CutScale, OfEnergiesHasBurnsFirstThenDarkToLightDownToNothing) {
  const CutScale scale = CutScale::of_energies(2.3, 9);
  EXPECT_EQ(scale.shade(9), 0U);
  EXPECT_EQ(scale.shade(2.30001), 0U);
  EXPECT_EQ(scale.shade(2.3), 1U);
  EXPECT_EQ(scale.shade(0), CutScale::kShades - 1);
  for (std::size_t shade = 1; shade < CutScale::kShades; ++shade) {
    EXPECT_EQ(scale.shade(scale.border(shade) * (1 - 1e-9)), shade);
    EXPECT_EQ(scale.shade(scale.border(shade) * (1 + 1e-9)), shade - 1);
  }
}

}  // namespace
}  // namespace kerf::output::plot
