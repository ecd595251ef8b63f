// Whatever a processor can do at once, the bits are the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

#include "stock/field/field_jobs.hpp"
#include "stock/field/field_tool.hpp"
#include "stock/field/straight_leg.hpp"

namespace kerf::stock::field {
namespace {

constexpr double kCell = 0.1;
constexpr double kHalf = 1.5 * kCell;

/// Of columns that are lower than before, mm.
struct Lowered {
  double removed = 0;
  float highest = -kNowhere;
  float lowest = kNowhere;
};

/// A tile of random heights, with bottoms that are not all 0.
class RandomTile {
 public:
  explicit RandomTile(std::mt19937& random) {
    std::uniform_real_distribution<float> height(0, 8);
    for (int i = 0; i < kTileSide; ++i) places_[static_cast<std::size_t>(i)] = i * kCell;
    for (std::size_t i = 0; i < kTileCells; ++i) {
      bottoms_[i] = i % 7 == 0 ? height(random) : 0;
      heights_[i] = std::max(bottoms_[i], height(random));
    }
    for (std::size_t block = 0; block < tops_.size(); ++block) {
      const float* const first = heights_.data() + block * kBlockCells;
      tops_[block] = *std::max_element(first, first + kBlockCells);
    }
    for (std::size_t i = 0; i < kTileBlocks; ++i) {
      middles_[i] = static_cast<float>(4 * kCell * static_cast<double>(i) + kHalf);
      rows_[i] = static_cast<double>(middles_[i]);
    }
  }
  [[nodiscard]] Columns::Tile tile() {
    return {heights_.data(), owners_.data(), tops_.data(),
            bottoms_.data(), places_.data(), places_.data()};
  }
  [[nodiscard]] BlockGrid blocks() const {
    return {.x = middles_.data(), .y = rows_.data(), .tops = tops_.data(), .half = {kHalf, kHalf}};
  }
  /// How much lower another one is.
  [[nodiscard]] Lowered lowered_to(const RandomTile& other) const {
    Lowered of;
    for (std::size_t i = 0; i < kTileCells; ++i) {
      const float before = heights_[i];
      const float after = other.heights_[i];
      if (!(after < before)) continue;
      of.removed += static_cast<double>(before - after);
      of.highest = std::max(of.highest, before);
      of.lowest = std::min(of.lowest, after);
    }
    return of;
  }
  /// All columns in which another one differs are in a box, seen from above.
  [[nodiscard]] bool differs_only_in(const Bounds& box, const RandomTile& other) const {
    for (int block = 0; block < kTileBlocks * kTileBlocks; ++block) {
      for (int i = 0; i < kBlockCells; ++i) {
        const auto column = static_cast<std::size_t>(block * kBlockCells + i);
        const double x = kCell * (block % kTileBlocks * kBlockSide + i % kBlockSide);
        const double y = kCell * (block / kTileBlocks * kBlockSide + i / kBlockSide);
        const bool is_in = x >= box.low.x && x <= box.high.x && y >= box.low.y && y <= box.high.y;
        if (!is_in && heights_[column] != other.heights_[column]) return false;
      }
    }
    return true;
  }
  [[nodiscard]] bool is(const RandomTile& other) const {
    return heights_ == other.heights_ && owners_ == other.owners_ && tops_ == other.tops_;
  }

 private:
  std::array<float, kTileCells> heights_{};
  std::array<float, kTileCells> bottoms_{};
  std::array<std::uint32_t, kTileCells> owners_{};
  std::array<float, kTileBlocks * kTileBlocks> tops_{};
  std::array<double, kTileSide> places_{};
  std::array<float, kTileBlocks> middles_{};
  std::array<double, kTileBlocks> rows_{};
};

/// Everything that one width of registers does for a leg.
struct Done {
  BlockMasks met{};
  std::vector<std::size_t> lowered;
  Taken taken;
};

Done work(const LaneWork& lanes, const StraightLeg& leg, const LowerEnvelope& tool,
          RandomTile& material) {
  const StraightLeg::View view = leg.view(tool, 0, {kHalf, kHalf}, lanes);
  const Columns::Tile tile = material.tile();
  Done done;
  done.taken.bins_per_mm = 8;
  done.taken.reach = 4;
  view.meets(material.blocks(), done.met);
  std::vector<int> blocks;
  for (int block = 0; block < kTileBlocks * kTileBlocks; ++block) blocks.push_back(block);
  std::vector<Look> looks(blocks.size());
  done.lowered.resize(blocks.size() + 1);
  done.lowered.resize(view.look(tile, blocks, looks.data(), done.lowered.data()));
  lanes.settle(tile, 5, blocks, looks.data(), done.lowered, done.taken);
  return done;
}

void expect_same(const Done& a, const Done& b) {
  EXPECT_EQ(a.met, b.met);
  EXPECT_EQ(a.lowered, b.lowered);
  EXPECT_EQ(a.taken.left, b.taken.left);
  EXPECT_EQ(a.taken.right, b.taken.right);
  EXPECT_EQ(a.taken.highest, b.taken.highest);
  EXPECT_EQ(a.taken.lowest, b.taken.lowest);
  EXPECT_EQ(a.taken.heights, b.taken.heights);
  EXPECT_EQ(a.taken.across, b.taken.across);
}

/// Sums, sides and bins, column by column, of what was there before and after.
void expect_sums(const Done& done, const Lowered& of) {
  double heights = 0;
  double across = 0;
  for (const double part : done.taken.heights) heights += part;
  for (const auto& part : done.taken.across)
    across = std::accumulate(part.begin(), part.end(), across);
  EXPECT_NEAR(heights, of.removed, 1e-9 * (1 + of.removed));
  EXPECT_NEAR(across, of.removed, 1e-9 * (1 + of.removed));
  EXPECT_EQ(done.taken.highest, of.highest);
  EXPECT_EQ(done.taken.lowest, of.lowest);
}

/// The blocks that were told to be met hold all those that were lowered.
void expect_none_missed(const Done& done) {
  for (const std::size_t block : done.lowered)
    EXPECT_TRUE((done.met[block / kTileBlocks] >> (block % kTileBlocks) & 1U) != 0) << block;
}

/// Level, sloped, steep or vertical, in and around the tile.
StraightWay random_way(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-3, 9);
  std::uniform_real_distribution<double> height(-1, 7);
  StraightWay way{{place(random), place(random), height(random)},
                  {place(random), place(random), height(random)}};
  const auto kind = random() % 5;
  if (kind == 0) way.to.z = way.from.z;
  if (kind == 1) way.to = {way.from.x, way.from.y, way.to.z};
  if (kind == 2)
    way.to = {way.from.x + (way.to.x - way.from.x) / 50, way.from.y + (way.to.y - way.from.y) / 50,
              way.to.z};
  return way;
}

class LaneWorks : public testing::TestWithParam<int> {};

TEST_P(LaneWorks, AgreeToTheLastBit) {
  const std::vector<Body> bodies = {ball(6), flat(5), bull(6, 1), cone(6, 90, 0, 20),
                                    cone(4, 118, 0, 20)};
  const Body& body = bodies[static_cast<std::size_t>(GetParam())];
  const FieldTool tool(body, 0.001);
  std::mt19937 random(20261127);
  std::size_t lowered = 0;
  for (int i = 0; i < 200; ++i) {
    const RandomTile tile(random);
    const StraightLeg leg(random_way(random), i % 2 == 0 ? StraightLeg::Begins::afresh
                                                         : StraightLeg::Begins::behind_itself);
    RandomTile narrow = tile;
    const Done first = work(*lane_works().front(), leg, tool.edges(), narrow);
    expect_none_missed(first);
    expect_sums(first, tile.lowered_to(narrow));
    EXPECT_TRUE(tile.differs_only_in(leg.reached(tool.edges()), narrow)) << i;
    lowered += first.lowered.size();
    for (const LaneWork* const wider : lane_works().subspan(1)) {
      RandomTile wide = tile;
      expect_same(first, work(*wider, leg, tool.edges(), wide));
      EXPECT_TRUE(wide.is(narrow));
    }
  }
  EXPECT_GT(lowered, 1000U);
}

INSTANTIATE_TEST_SUITE_P(Tools, LaneWorks, testing::Range(0, 5));

}  // namespace
}  // namespace kerf::stock::field
