#include "stock/field/height_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "math/math.hpp"
#include "stock/field/field_jobs.hpp"

namespace kerf::stock::field {
namespace {

using std::numbers::pi;

const Bounds kBox{{0, 0, -20}, {60, 40, 0}};

/// A raster, then random moves with several tools, rapids among them.
std::vector<Sweep> many_sweeps() {
  std::mt19937_64 bits{7};
  const auto in = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  std::vector<Sweep> sweeps;
  Vec3 at{5, 5, -1};
  const auto add = [&](const Way& way, SweepKind kind, BodyId body) {
    sweeps.push_back({.way = way, .body = body, .kind = kind});
    sweeps.back().motion = static_cast<std::uint32_t>(sweeps.size());
    at = point_at(way, 1);
  };
  for (int i = 0; i < 700; ++i) {
    const Vec3 to{5 + 0.07 * i, 20 + 10 * math::sin(0.02 * i), -3 - 2 * math::cos(0.05 * i)};
    add(StraightWay{at, to}, SweepKind::cut, 0);
  }
  for (int i = 0; i < 120; ++i) {
    const Vec3 to{in(0, 60), in(0, 40), in(-8, 2)};
    const auto kind = i % 5 == 0 ? SweepKind::rapid : SweepKind::cut;
    add(StraightWay{at, to}, kind, static_cast<BodyId>(i % 3));
    if (i % 4 == 0) add(around(at + Vec3{3, 0, 0}, at, 7, -0.5), SweepKind::cut, 1);
  }
  return sweeps;
}

struct Result {
  std::vector<Outcome> outcomes;
  std::vector<TileState> tiles;
};

void add_tools(HeightField& field) {
  ASSERT_EQ(field.add_body(ball(6)), 0U);
  ASSERT_EQ(field.add_body(with(bull(10, 2, 6), ToolPart::holder, 24, 30)), 1U);
  ASSERT_EQ(field.add_body(with(flat(8, 4), ToolPart::flank, 8, 20)), 2U);
}

Result run(unsigned jobs, std::size_t batch) {
  HeightField field(grid_of(kBox, 0.2), jobs);
  add_tools(field);
  const std::vector<Sweep> sweeps = many_sweeps();
  Result result;
  result.outcomes.resize(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); i += batch) {
    const std::size_t n = std::min(batch, sweeps.size() - i);
    field.cut(std::span(sweeps).subspan(i, n), std::span(result.outcomes).subspan(i, n));
  }
  for (std::size_t tile = 0; tile < field.columns().grid().tiles(); ++tile) {
    result.tiles.push_back(field.columns().state(tile));
  }
  return result;
}

bool operator==(const Contact& a, const Contact& b) {
  return a.depth_mm == b.depth_mm && a.at == b.at && a.volume == b.volume;
}

void expect_same(const Result& a, const Result& b) {
  for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
    const Outcome& x = a.outcomes[i];
    const Outcome& y = b.outcomes[i];
    ASSERT_TRUE(x.removed == y.removed && x.core == y.core && x.across == y.across &&
                x.visited == y.visited)
        << i;
    for (std::size_t p = 0; p < kToolParts; ++p) ASSERT_TRUE(x.contacts[p] == y.contacts[p]) << i;
  }
  for (std::size_t t = 0; t < a.tiles.size(); ++t) {
    ASSERT_EQ(a.tiles[t].heights, b.tiles[t].heights);
    ASSERT_EQ(a.tiles[t].owners, b.tiles[t].owners);
  }
}

TEST(HeightField, IsTheSameForAnyNumberOfThreadsAndAnyBatches) {
  const Result one = run(1, 100000);
  Exact removed;
  int contacts = 0;
  for (const Outcome& outcome : one.outcomes) {
    removed += outcome.removed;
    for (const Contact& contact : outcome.contacts) contacts += contact.is_one() ? 1 : 0;
  }
  EXPECT_GT(removed.value(), 1000);
  EXPECT_GT(contacts, 10);
  for (const unsigned jobs : {1U, 2U, 7U}) {
    for (const std::size_t batch : {std::size_t{1}, std::size_t{13}, std::size_t{100000}}) {
      SCOPED_TRACE(testing::Message() << jobs << " jobs, batches of " << batch);
      expect_same(one, run(jobs, batch));
    }
  }
}

TEST(HeightField, GoesOnFromWhatWasKeptAsIfNothingHadBeen) {
  const std::vector<Sweep> sweeps = many_sweeps();
  const std::size_t half = sweeps.size() / 2;  // within the raster
  std::vector<Outcome> outcomes(sweeps.size());
  HeightField first(grid_of(kBox, 0.2), 1);
  HeightField second(grid_of(kBox, 0.2), 1);
  add_tools(first);
  add_tools(second);
  first.cut(std::span(sweeps).first(half), std::span(outcomes).first(half));
  for (std::size_t tile = 0; tile < first.columns().grid().tiles(); ++tile) {
    second.restore(tile, first.columns().state(tile));
    EXPECT_GT(second.columns().version(tile), 0U);
  }
  second.restore_last(first.last());
  std::vector<Outcome> again(sweeps.size());
  first.cut(std::span(sweeps).subspan(half), std::span(outcomes).subspan(half));
  second.cut(std::span(sweeps).subspan(half), std::span(again).subspan(half));
  for (std::size_t i = half; i < sweeps.size(); ++i) {
    ASSERT_EQ(outcomes[i].removed, again[i].removed) << i;
  }
  EXPECT_EQ(first.left_mm3(), second.left_mm3());
}

TEST(HeightField, KnowsWhoCutAColumnAndWhichTilesHaveChanged) {
  Job job(kBox, 0.25, flat(6));
  job.at({10, 10, 5}).to({10, 10, -2}).to({20, 10, -2});
  const Columns& columns = job.field().columns();
  EXPECT_EQ(columns.owner(40, 40), 1U);
  EXPECT_EQ(columns.owner(80, 40), 2U);
  EXPECT_EQ(columns.owner(200, 40), 0U);
  EXPECT_EQ(columns.height(40, 40), 18);
  EXPECT_EQ(columns.version(0), 2U);
  EXPECT_EQ(columns.version(columns.grid().tiles() - 1), 0U);
}

TEST(HeightField, SharesWhatItRemovesOutToBothSidesOfTheWay) {
  Job job(kBox, 0.1, flat(10));
  job.at({-10, 0, -2}).to({70, 0, -2});  // half in the stock, which lies on its left
  double left = 0;
  double right = 0;
  for (std::size_t bin = 0; bin < Outcome::kBins; ++bin) {
    (bin < Outcome::kBins / 2 ? right : left) += job.last().across[bin].value();
  }
  EXPECT_NEAR(left, 60 * 5 * 2, 1e-3);
  EXPECT_EQ(right, 0);
  job.at({70, 0, -4}).to({-10, 0, -4});
  EXPECT_NEAR(job.last().across[0].value(), 60 * 2 * 10.0 / 64, 10);
  job.at({30, 20, 0}).turn({30, 10, 0}, 0.5).at({20, 10, -4}).turn({30, 10, 0}, -1);
  EXPECT_GT(job.last().across[10].value(), 0);
  EXPECT_GT(job.last().across[53].value(), 0);
}

TEST(HeightField, HoldsOtherStockThanABox) {
  // A tube along Z: 10 inside, 30 outside, on a slanted bottom.
  const auto tube = [](double x, double y) -> Column {
    const double r = std::sqrt(x * x + y * y);
    if (r < 5 || r > 15) return {};
    return {-20 + 0.1 * (x + 15), -5};
  };
  HeightField field(grid_of({{-15, -15, -20}, {15, 15, -5}}, 0.1), tube, 2);
  EXPECT_NEAR(field.stock_mm3(), pi * 200 * (15 - 1.5), pi * 200 * 13.5 * 0.002);
  const BodyId tool = field.add_body(flat(60));
  const Sweep sweep{.way = StraightWay{{0, 0, 5}, {0, 0, -30}}, .body = tool, .motion = 1};
  Outcome outcome;
  field.cut({&sweep, 1}, {&outcome, 1});
  EXPECT_NEAR(outcome.removed.value(), field.stock_mm3(), 1e-3);
  EXPECT_EQ(field.left_mm3(), 0);
  EXPECT_GT(field.extents().low.x, field.extents().high.x);
}

TEST(HeightField, HasTheExtentsOfWhatIsLeft) {
  Job job(kBox, 0.1, flat(20));
  job.at({-20, 10, -2}).to({80, 10, -2}).at({-20, 30, -2}).to({80, 30, -2});
  const Bounds all = job.field().extents();
  EXPECT_NEAR(all.high.z, -2, 1e-5);
  EXPECT_NEAR(all.low.z, -20, 1e-9);
  job.at({-5, -20, -30}).to({-5, 60, -30});
  EXPECT_NEAR(job.field().extents().low.x, 5, 1e-9);
}

TEST(HeightField, BoundsItsErrorByTheWallsThatWereCut) {
  Job job({{-20, -20, -20}, {20, 20, 0}}, 0.25, flat(10));
  EXPECT_EQ(job.field().error_mm3(), 0);
  job.at({0.03, 0.07, 5}).to({0.03, 0.07, -8});
  const double wanted = 0.125 * 8 * (4 * 10);  // the steps of a circle are its four sides
  EXPECT_NEAR(job.field().error_mm3(), wanted, wanted * 0.05);
  EXPECT_LT(std::abs(job.removed() - pi * 25 * 8), job.field().error_mm3());
}

TEST(HeightField, TakesTheBytesThatItSays) {
  const Grid grid = grid_of(kBox, 0.05);
  const HeightField field(grid, 1);
  const auto said = static_cast<double>(HeightField::bytes_of(grid, true));
  EXPECT_NEAR(static_cast<double>(field.bytes()) / said, 1, 0.01);
}

TEST(HeightField, SaysWhatItCannotCut) {
  HeightField field(grid_of(kBox, 1), 1);
  const BodyId mill = field.add_body(flat(6));
  const BodyId slot = field.add_body({.profile = Profile({{{0, 0}, {8, 0}},
                                                          {{8, 0}, {8, 4}},
                                                          {{8, 4}, {3, 4}},
                                                          {{3, 4}, {3, 30}, 0, ToolPart::shank}})});
  const Way way = StraightWay{{0, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(field.can_cut({.way = way, .body = mill}));
  EXPECT_FALSE(field.can_cut({.way = way, .body = slot}));
  EXPECT_FALSE(field.can_cut({.way = way, .body = 17}));
  EXPECT_FALSE(field.can_cut({.way = way, .axis = {0, 1, 0}, .body = mill}));
  EXPECT_FALSE(field.can_cut({.way = TurningWay{{}, {}, {0, 0, 1}}, .body = mill}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(field.can_cut({.way = StraightWay{{nan, 0, 0}, {}}, .body = mill}));
  EXPECT_FALSE(field.can_cut({.way = StraightWay{{1e300, 0, 0}, {}}, .body = mill}));
  EXPECT_FALSE(field.can_cut({.way = around({}, {1e6, 0, 0}, 1e6, -5), .body = mill}));
}

TEST(HeightField, TakesWaysOfAnyLength) {
  HeightField field(grid_of(kBox, 0.5), 2);
  const BodyId mill = field.add_body(flat(6));
  const std::vector<Sweep> sweeps = {
      {.way = StraightWay{{-1e6, 20, -1}, {1e6, 20, -1}}, .body = mill, .motion = 1},
      {.way = StraightWay{{30, 20, 1e6}, {30, 20, -1e6}}, .body = mill, .motion = 2},
      {.way = around({30, 20, 0}, {40, 20, -2}, 1e5), .body = mill, .motion = 3},
      {.way = StraightWay{{5, 5, -3}, {5, 5, -3}}, .body = mill, .motion = 4},
      {.way = around({30, 6000, 0}, {30, 35, -2}, 0.01, -1e-3), .body = mill, .motion = 5}};
  std::vector<Outcome> outcomes(sweeps.size());
  for (const Sweep& sweep : sweeps) ASSERT_TRUE(field.can_cut(sweep));
  field.cut(sweeps, outcomes);
  EXPECT_NEAR(outcomes[0].removed.value(), 60 * 6 * 1, 1);
  EXPECT_NEAR(outcomes[1].removed.value(), pi * 9 * 19, pi * 9 * 19 * 0.05);
  EXPECT_GT(outcomes[2].removed.value(), 2 * pi * 10 * 6);
  EXPECT_NEAR(outcomes[3].removed.value(), pi * 9 * 3, pi * 9 * 3 * 0.05);
  EXPECT_GT(outcomes[4].removed.value(), 10);
}

TEST(HeightField, HasNoWorkForThreadsWhereNothingIsMet) {
  HeightField field(grid_of(kBox, 0.1), 7);
  const BodyId mill = field.add_body(flat(6));
  const std::vector<Sweep> sweeps = {
      {.way = StraightWay{{-500, -400, -1}, {600, -300, -1}}, .body = mill},
      {.way = StraightWay{{-500, -400, 1}, {600, 300, 1}}, .body = mill}};
  std::vector<Outcome> outcomes(sweeps.size());
  field.cut(sweeps, outcomes);
  EXPECT_EQ(field.left_mm3(), field.stock_mm3());
}

TEST(Probe, StopsWhereItsBallTouchesAFace) {
  HeightField field(grid_of(kBox, 0.1), 1);
  const auto stops = [&](Vec3 from, Vec3 to) {
    const Vec3 up{0, 0, 2};  // ways of the tip, a ball of 4 mm
    return field.first_touch({{from + up, to + up}, 2});
  };
  EXPECT_NEAR(stops({30, 20, 10}, {30, 20, -10}).value(), 0.5, 1e-9);
  EXPECT_NEAR(stops({-12, 20, -6}, {8, 20, -6}).value(), 0.5, 1e-9);
  // Down a slope of 45° the ball's contact is √2 - 1 radii below where its tip gets to the face.
  EXPECT_NEAR(stops({10, 20, 10}, {30, 20, -10}).value(), 0.5, 1e-3);
  EXPECT_FALSE(stops({-12, 20, 5}, {80, 20, 0.001}).has_value());
  EXPECT_FALSE(stops({-12, 20, -25}, {80, 20, -25}).has_value());  // below it all
  EXPECT_EQ(stops({30, 20, -1}, {30, 20, 10}).value(), 0);
}

}  // namespace
}  // namespace kerf::stock::field
