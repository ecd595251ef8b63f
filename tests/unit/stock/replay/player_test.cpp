// A part at any time of its run is the same to the last bit, however one comes there.
#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <random>

#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"
#include "stock/replay/model_player.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::replay {
namespace {

const Bounds kBox{{-20, -15, -10}, {20, 15, 0}};

Body flat(double diameter) {
  const double r = diameter / 2;
  return {Profile({{{0, 0}, {r, 0}, 0, ToolPart::edge}, {{r, 0}, {r, 100}, 0, ToolPart::edge}})};
}

using Made = std::function<std::unique_ptr<Model>()>;

/// A run of random moves with two tools, a second each, with pauses of half a second between.
class PlayedRun {
 public:
  PlayedRun(const Made& made, unsigned seed, std::size_t memory_bytes)
      : model_(made()), recording_(*model_, {.memory_bytes = memory_bytes, .interval_s = 0}) {
    for (const double diameter : {4.0, 7.0}) {
      static_cast<void>(model_->add_body(flat(diameter)));
      recording_.added(flat(diameter));
    }
    cut(sweeps(seed));
  }

  static constexpr int kMoves = 60;
  static constexpr double kLasts_s = 1.5 * kMoves;

  [[nodiscard]] const Recording& recording() const { return recording_; }
  [[nodiscard]] Model& model() { return *model_; }

 private:
  static std::vector<Sweep> sweeps(unsigned seed) {
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) {
      return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    std::vector<Sweep> all;
    Vec3 tip{0, 0, 5};
    for (std::uint32_t i = 1; i <= kMoves; ++i) {
      const Vec3 to{draw(-18, 18), draw(-13, 13), draw(-8, 2)};
      Sweep sweep{.way = StraightWay{tip, to}, .body = i / 9 % 2, .motion = i};
      if (i % 5 == 0)
        sweep.way = ArcWay{tip, {0, 0, draw(-1, 1)}, {1, 0, 0}, {0, 1, 0}, 3, 0, 0, draw(1, 6)};
      tip = point_at(sweep.way, 1);
      all.push_back(sweep);
    }
    return all;
  }

  void cut(const std::vector<Sweep>& sweeps) {
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
      const std::span<const Sweep> one(&sweeps[i], 1);
      std::vector<Outcome> outcome(1);
      model_->cut(one, outcome);
      recording_.cut(one);
      const double start_s = 1.5 * static_cast<double>(i);
      recording_.tell(sweeps[i].motion, start_s, start_s + 1);
    }
    recording_.finish(kLasts_s);
  }

  std::unique_ptr<Model> model_;
  Recording recording_;
};

/// All bits of a model that can be seen.
std::vector<std::uint32_t> bits_of(const Model& model) {
  std::vector<std::uint32_t> bits;
  const auto add = [&](float value) { bits.push_back(std::bit_cast<std::uint32_t>(value)); };
  if (const auto* field = dynamic_cast<const field::HeightField*>(&model)) {
    const field::Grid& grid = field->columns().grid();
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        add(field->columns().height(i, j));
        bits.push_back(field->columns().owner(i, j));
      }
    }
  }
  if (const auto* dexels = dynamic_cast<const dexel::TriDexel*>(&model)) {
    for (int grid = 0; grid < 3; ++grid) {
      for (std::size_t i = 0; i < dexels->tiles(grid); ++i) {
        for (const dexel::DexelEnd& end : dexels->save(grid, i).ends) {
          add(end.at);
          bits.push_back(end.motion);
        }
      }
    }
  }
  return bits;
}

std::unique_ptr<Model> height_field() {
  return std::make_unique<field::HeightField>(field::grid_of(kBox, 0.25), 1);
}
std::unique_ptr<Model> tri_dexel() {
  return std::make_unique<dexel::TriDexel>(dexel::box_shape(kBox), 0.5, 1);
}

/// What a player that was never anywhere else shows at a time.
std::vector<std::uint32_t> fresh(const Made& made, const Recording& recording, double time_s) {
  ModelPlayer player(made(), recording, {.is_alike = false});
  EXPECT_TRUE(player.go_to(time_s, {}));
  return bits_of(player.model());
}

void there_and_back(const Made& made) {
  PlayedRun run(made, 7, std::size_t{64} << 20U);
  ModelPlayer player(made(), run.recording(), {});
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    const double time_s = PlayedRun::kLasts_s * static_cast<double>(random()) / 4294967296.0;
    ASSERT_TRUE(player.go_to(time_s, {}));
    ASSERT_EQ(bits_of(player.model()), fresh(made, run.recording(), time_s)) << time_s << " s";
  }
  ASSERT_TRUE(player.go_to(1e9, {}));
  EXPECT_EQ(bits_of(player.model()), bits_of(run.model()));
}

TEST(Player, ThereAndBackAHeightFieldHasTheSameBits) { there_and_back(height_field); }
TEST(Player, ThereAndBackDexelsHaveTheSameBits) { there_and_back(tri_dexel); }

TEST(Player, FewerCheckpointsMakeTheSameBits) {
  PlayedRun many(height_field, 11, std::size_t{64} << 20U);
  PlayedRun few(height_field, 11, std::size_t{2} << 20U);
  ModelPlayer a(height_field(), many.recording(), {});
  ModelPlayer b(height_field(), few.recording(), {});
  for (const double time_s : {80.3, 12.25, 55.0, 3.75}) {
    ASSERT_TRUE(a.go_to(time_s, {}));
    ASSERT_TRUE(b.go_to(time_s, {}));
    EXPECT_EQ(bits_of(a.model()), bits_of(b.model())) << time_s << " s";
  }
  EXPECT_LT(few.recording().record().bytes(), std::size_t{2} << 20U);
}

// The same job as a lathe: what is left is one region.
TEST(Player, ATurnedPartComesBack) {
  const Made made = [] { return std::make_unique<turned::TurnedPart>(turned::bar(40, -60, 0)); };
  const auto model = made();
  Recording recording(*model, {.interval_s = 0});
  static_cast<void>(model->add_body(flat(10)));
  recording.added(flat(10));
  for (std::uint32_t i = 1; i <= 4; ++i) {
    const double deep = -8.0 * i;
    const Sweep sweep{.way = StraightWay{{0, 0, deep + 8}, {0, 0, deep}}, .motion = i};
    std::vector<Outcome> outcome(1);
    model->cut({&sweep, 1}, outcome);
    recording.cut({&sweep, 1});
    recording.tell(i, i - 1, i);
  }
  ModelPlayer player(made(), recording, {});
  const auto left = [&](double time_s) {
    EXPECT_TRUE(player.go_to(time_s, {}));
    return player.model().stock_mm3() - player.model().left_mm3();
  };
  constexpr double kDisc = 3.14159265358979 * 25;
  EXPECT_NEAR(left(4), kDisc * 32, 1e-6);
  EXPECT_NEAR(left(1.5), kDisc * 12, 1e-6);
  EXPECT_NEAR(left(0), 0, 1e-9);
  EXPECT_NEAR(left(3), kDisc * 24, 1e-6);
}

TEST(Player, WhoIsNoLongerWantedStopsAndGoesOnLater) {
  PlayedRun run(height_field, 5, std::size_t{64} << 20U);
  ModelPlayer player(height_field(), run.recording(), {.is_alike = false});
  std::stop_source unwanted;
  unwanted.request_stop();
  EXPECT_FALSE(player.go_to(70, unwanted.get_token()));
  ASSERT_TRUE(player.go_to(70, {}));
  EXPECT_EQ(bits_of(player.model()), fresh(height_field, run.recording(), 70));
}

TEST(Timeline, AMotionIsDoneInPartByTime) {
  Timeline line;
  line.add(1, 3, 10);
  line.add(4, 5, 12);
  EXPECT_EQ(line.at(0.5), (Instant{0, 0, 0}));
  EXPECT_EQ(line.at(2), (Instant{0, 10, 0.5}));
  EXPECT_EQ(line.at(3.5), (Instant{10, 10, 0}));
  EXPECT_EQ(line.at(4.25), (Instant{10, 12, 0.25}));
  EXPECT_EQ(line.at(99), (Instant{12, 12, 0}));
}

TEST(SweepLog, GivesBackWhatItGot) {
  SweepLog log;
  const std::vector<Sweep> some{
      {.way = StraightWay{{0, 0, 0}, {1, 2, 3}}, .motion = 1},
      {.way = StraightWay{{1, 2, 3}, {4, 5, 6}}, .motion = 2},
      {.way = ArcWay{{}, {}, {1, 0, 0}, {0, 1, 0}, 3, 0, 0, 1},
       .body = 2,
       .kind = SweepKind::rapid,
       .motion = 4},
      {.way = TurningWay{{1, 1, 1}, {2, 2, 2}, {0, 1, 0}}, .axis = {1, 0, 0}, .motion = 5},
      {.way = StraightWay{{9, 2, 3}, {4, 5, 6}}, .motion = 6, .lead_mm = 2, .start_deg = 90}};
  for (const Sweep& sweep : some) log.add(sweep);
  ASSERT_EQ(log.size(), some.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    const Sweep back = log[i];
    EXPECT_EQ(back.motion, some[i].motion);
    EXPECT_EQ(back.body, some[i].body);
    EXPECT_EQ(back.kind, some[i].kind);
    EXPECT_EQ(back.axis, some[i].axis);
    EXPECT_EQ(back.lead_mm, some[i].lead_mm);
    EXPECT_EQ(point_at(back.way, 0), point_at(some[i].way, 0));
    EXPECT_EQ(point_at(back.way, 1), point_at(some[i].way, 1));
  }
}

}  // namespace
}  // namespace kerf::stock::replay
