// A sheet at any time of its run is the same to the last bit, however one comes there.
#include "stock/replay/sheet_player.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kerf::stock::replay {
namespace {

using sheet::Burn;
using sheet::Sheet;
using sheet::Trace;

std::unique_ptr<Sheet> untouched() {
  return std::make_unique<Sheet>(sheet::grid_of({{0, 0}, {60, 40}}, 0.25),
                                 Sheet::Settings{.kerf_mm = 0.4, .spot_mm = 0.5});
}

constexpr std::uint32_t kMoves = 50;

/// A way a second, with a burn each quarter of it.
void cut(SheetRecording& recording, Sheet& sheet) {
  std::mt19937 random(9);
  const auto draw = [&](double high) {
    return high * static_cast<double>(random()) / 4294967296.0;
  };
  for (std::uint32_t i = 1; i <= kMoves; ++i) {
    const sheet::Vec2 to{draw(60), draw(40)};
    const Trace way = i % 4 == 0 ? sheet::round(to, 3, draw(6), 0.5 + draw(5))
                                 : sheet::straight({draw(60), draw(40)}, to);
    const std::vector<Trace> traces{way};
    const std::vector<std::uint32_t> motions{i};
    std::vector<Burn> burns;
    std::vector<double> until_s;
    for (int k = 0; k < 4; ++k) {
      burns.push_back({way.from + (k / 4.0) * (way.to - way.from),
                       way.from + ((k + 1) / 4.0) * (way.to - way.from), 2});
      until_s.push_back(i - 1 + (k + 1) / 4.0);
    }
    sheet.cut(traces);
    sheet.burn(burns);
    recording.cut(traces, motions);
    recording.burn(burns, until_s);
    recording.tell(i, i - 1, i);
  }
  recording.finish(kMoves);
}

std::vector<float> bits_of(const Sheet& sheet) {
  std::vector<float> all;
  for (std::size_t tile = 0; tile < sheet.grid().tiles(); ++tile) {
    const auto* const cells = sheet.coverage(tile);
    const auto* const energy = sheet.energy(tile);
    for (std::size_t i = 0; i < sheet::kTileCells; ++i) {
      all.push_back(cells == nullptr ? 0 : static_cast<float>((*cells)[i]));
      all.push_back(energy == nullptr ? 0 : (*energy)[i]);
    }
  }
  return all;
}

TEST(SheetPlayer, ThereAndBackIsTheSame) {
  const auto sheet = untouched();
  SheetRecording recording(*sheet, {.interval_s = 0});
  cut(recording, *sheet);
  SheetPlayer player(untouched(), recording);
  std::mt19937 random(4);
  for (int i = 0; i < 25; ++i) {
    const double time_s = kMoves * static_cast<double>(random()) / 4294967296.0;
    ASSERT_TRUE(player.go_to(time_s, {}));
    SheetPlayer fresh(untouched(), recording);
    ASSERT_TRUE(fresh.go_to(time_s, {}));
    ASSERT_EQ(bits_of(player.sheet()), bits_of(fresh.sheet())) << time_s << " s";
  }
  ASSERT_TRUE(player.go_to(kMoves, {}));
  EXPECT_EQ(bits_of(player.sheet()), bits_of(*sheet));
}

TEST(SheetPlayer, OfAWayUnderWayAPartIsCutAndBurnt) {
  const auto sheet = untouched();
  SheetRecording recording(*sheet, {.interval_s = 0});
  const std::vector<Trace> way{sheet::straight({10, 20}, {50, 20})};
  const std::vector<std::uint32_t> motion{1};
  const std::vector<Burn> burn{{{10, 20}, {50, 20}, 8}};
  const std::vector<double> until_s{4};
  sheet->cut(way);
  sheet->burn(burn);
  recording.cut(way, motion);
  recording.burn(burn, until_s);
  recording.tell(1, 0, 4);
  SheetPlayer player(untouched(), recording);
  constexpr double kEnds = 3.14159265358979 * 0.04;
  const double cell = 0.25 * 0.25;
  const double whole_j = sheet->energy_on_sheet_j();
  for (const double share : {0.25, 0.75, 0.5}) {
    ASSERT_TRUE(player.go_to(4 * share, {}));
    EXPECT_NEAR(player.sheet().cut_mm2(), 40 * share * 0.4 + kEnds, 4 * cell);
    EXPECT_NEAR(player.sheet().energy_on_sheet_j(), whole_j * share, 0.1);
  }
}

TEST(Trace, ItsBeginningIsAPartOfItsWay) {
  const Trace line = sheet::straight({1, 2}, {5, 2});
  EXPECT_DOUBLE_EQ(sheet::length(sheet::part(line, 0.25)), 1);
  const Trace arc = sheet::round({0, 0}, 2, 1, 3);
  const Trace half = sheet::part(arc, 0.5);
  EXPECT_NEAR(sheet::length(half), 3, 1e-12);
  EXPECT_NEAR(half.from.u, arc.from.u, 1e-12);
  EXPECT_NEAR(half.to.u, 2 * std::cos(2.5), 1e-12);
}

}  // namespace
}  // namespace kerf::stock::replay
