// What must not matter does not: threads, batches, mirrors, halves, order.
#include <random>

#include "mill.hpp"

namespace kerf::stock::dexel::test {
namespace {

/// Random moves of five tools in a box around 0.
std::vector<Sweep> random_sweeps(TriDexel& model, unsigned seed, int count, bool turns) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  Body face = flat(7);
  face.core_mm = 2;
  std::vector<BodyId> bodies;
  for (const Body& body : {ball(5), flat(4), bull(6, 1), t_slot(8, 2, 3), face}) {
    bodies.push_back(model.add_body(body));
  }
  std::vector<Sweep> sweeps;
  Vec3 tip{0, 0, 10};
  for (int i = 0; i < count; ++i) {
    Sweep sweep;
    sweep.body = bodies[static_cast<std::size_t>(i / 7) % bodies.size()];
    sweep.kind = draw(0, 1) < 0.8 ? SweepKind::cut : SweepKind::rapid;
    sweep.motion = static_cast<std::uint32_t>(i + 1);
    const Vec3 to{draw(-12, 12), draw(-12, 12), draw(-4, 6)};
    const double choice = draw(0, 1);
    if (choice < 0.6) {
      sweep.way = StraightWay{tip, to};
    } else if (choice < 0.9 || !turns) {
      sweep.way =
          ArcWay{tip, {0, 0, draw(-2, 2)}, {1, 0, 0}, {0, 1, 0}, 3, draw(-1, 1), 0, draw(-7, 7)};
    } else {
      sweep.way = TurningWay{tip, to, geometry::unit({draw(-0.2, 0.2), draw(-0.2, 0.2), 1})};
    }
    tip = point_at(sweep.way, 1);
    sweeps.push_back(sweep);
  }
  return sweeps;
}

struct Result {
  std::vector<TriDexel::TileState> tiles;
  std::vector<Outcome> outcomes;
};

std::vector<TriDexel::TileState> tiles_of(const TriDexel& model) {
  std::vector<TriDexel::TileState> all;
  for (int grid = 0; grid < 3; ++grid) {
    for (std::size_t i = 0; i < model.tiles(grid); ++i) all.push_back(model.save(grid, i));
  }
  return all;
}

const Bounds kBox{{-11, -10, -6}, {11, 10, 4}};

Result run(unsigned jobs, std::size_t batch) {
  TriDexel model(box_shape(kBox), 0.2, jobs);
  const std::vector<Sweep> sweeps = random_sweeps(model, 11, 60, true);
  Result result;
  result.outcomes.resize(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); i += batch) {
    const std::size_t count = std::min(batch, sweeps.size() - i);
    model.cut(std::span(sweeps).subspan(i, count), std::span(result.outcomes).subspan(i, count));
  }
  result.tiles = tiles_of(model);
  return result;
}

void expect_same(const Result& a, const Result& b) {
  EXPECT_TRUE(a.tiles == b.tiles);
  ASSERT_EQ(a.outcomes.size(), b.outcomes.size());
  for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
    const Outcome& x = a.outcomes[i];
    const Outcome& y = b.outcomes[i];
    EXPECT_EQ(x.removed, y.removed) << i;
    EXPECT_EQ(x.core, y.core) << i;
    EXPECT_EQ(x.across, y.across) << i;
    EXPECT_EQ(x.visited, y.visited) << i;
    for (std::size_t p = 0; p < kToolParts; ++p) {
      EXPECT_EQ(x.contacts[p].depth_mm, y.contacts[p].depth_mm) << i;
      EXPECT_EQ(x.contacts[p].at, y.contacts[p].at) << i;
      EXPECT_EQ(x.contacts[p].volume, y.contacts[p].volume) << i;
    }
  }
}

TEST(SameBits, WithAnyNumberOfThreads) {
  const Result one = run(1, 1000);
  expect_same(one, run(2, 1000));
  expect_same(one, run(7, 1000));
}

TEST(SameBits, HoweverTheCallsAreCut) {
  const Result all = run(2, 1000);
  expect_same(all, run(2, 1));
  expect_same(all, run(1, 13));
}

TEST(SameBits, AfterItWasSavedAndReadBack) {
  TriDexel first(box_shape(kBox), 0.2, 1);
  const std::vector<Sweep> sweeps = random_sweeps(first, 12, 40, true);
  std::vector<Outcome> outcomes(sweeps.size());
  const std::span<const Sweep> all(sweeps);
  first.cut(all.first(20), std::span(outcomes).first(20));
  TriDexel second(box_shape(kBox), 0.2, 1);
  (void)random_sweeps(second, 12, 1, true);
  for (int grid = 0; grid < 3; ++grid) {
    for (std::size_t i = 0; i < first.tiles(grid); ++i) {
      ASSERT_TRUE(second.restore(grid, i, first.save(grid, i)));
    }
  }
  EXPECT_EQ(first.left_mm3(), second.left_mm3());
  std::vector<Outcome> again(20);
  first.cut(all.subspan(20), std::span(outcomes).subspan(20));
  second.cut(all.subspan(20), again);
  EXPECT_TRUE(tiles_of(first) == tiles_of(second));
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(outcomes[20 + i].removed, again[i].removed);
}

TEST(SameBits, ATileIsNotRestoredFromWhatIsNone) {
  TriDexel model(box_shape(kBox), 0.5, 1);
  const auto good = model.save(0, 0);
  auto bad = good;
  bad.counts[0] = 3;
  EXPECT_FALSE(model.restore(0, 0, bad));
  bad = good;
  bad.counts.pop_back();
  EXPECT_FALSE(model.restore(0, 0, bad));
  bad = good;
  std::swap(bad.ends[0], bad.ends[1]);
  EXPECT_FALSE(model.restore(0, 0, bad));
  bad = good;
  bad.ends[1].at = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(model.restore(0, 0, bad));
  bad = good;
  bad.ends[1].at = 1e9F;
  EXPECT_FALSE(model.restore(0, 0, bad));
  bad = good;
  bad.ends.push_back(bad.ends[0]);
  EXPECT_FALSE(model.restore(0, 0, bad));
  EXPECT_TRUE(model.save(0, 0) == good);
  EXPECT_TRUE(model.restore(0, 0, good));
}

double sum_removed(const std::vector<Outcome>& outcomes) {
  double sum = 0;
  for (const Outcome& outcome : outcomes) sum += outcome.removed.value();
  return sum;
}

TEST(Cutting, TwiceRemovesNothing) {
  TriDexel model(box_shape(kBox), 0.2, 2);
  const std::vector<Sweep> sweeps = random_sweeps(model, 13, 60, true);
  std::vector<Outcome> first(sweeps.size());
  std::vector<Outcome> second(sweeps.size());
  model.cut(sweeps, first);
  const auto tiles = tiles_of(model);
  model.cut(sweeps, second);
  EXPECT_GT(sum_removed(first), 100);
  EXPECT_LT(sum_removed(second), 1e-5 * sum_removed(first));
}

TEST(Cutting, RemovesWhatIsThenGone) {
  TriDexel model(box_shape(kBox), 0.2, 2);
  const std::vector<Sweep> sweeps = random_sweeps(model, 14, 60, false);
  std::vector<Outcome> outcomes(sweeps.size());
  const double before = model.grids_mm3()[2];
  model.cut(sweeps, outcomes);
  EXPECT_NEAR(sum_removed(outcomes), before - model.grids_mm3()[2], 1e-4);
  EXPECT_NEAR(before, model.stock_mm3(), 1e-6 * before);
}

/// Depth of the deepest difference between two models of one lattice along their dexels.
double difference(const TriDexel& a, const TriDexel& b) {
  double sum = 0;
  for (int grid = 0; grid < 3; ++grid) {
    for (std::size_t i = 0; i < a.tiles(grid); ++i) {
      const auto x = a.save(grid, i);
      const auto y = b.save(grid, i);
      if (x.counts != y.counts) return 1e9;
      for (std::size_t k = 0; k < x.ends.size(); ++k) {
        sum = std::max(sum, std::fabs(double{x.ends[k].at} - double{y.ends[k].at}));
      }
    }
  }
  return sum;
}

TEST(Cutting, InTwoPartsLeavesTheSameWithinTwiceTheBound) {
  std::mt19937 random(5);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  for (int i = 0; i < 40; ++i) {
    Mill whole({{-8, -7, -5}, {8, 7, 3}}, 0.4);
    Mill halves({{-8, -7, -5}, {8, 7, 3}}, 0.4);
    const Body body = std::vector<Body>{ball(5), flat(4), pointed(6, 30),
                                        bull(6, 1)}[static_cast<std::size_t>(i % 4)];
    const Vec3 axis = geometry::unit({draw(-1, 1), draw(-1, 1), draw(0.2, 1)});
    const StraightWay way{{draw(-9, 9), draw(-9, 9), draw(-6, 5)},
                          {draw(-9, 9), draw(-9, 9), draw(-6, 5)}};
    const double cut = draw(0.1, 0.9);
    whole.tool(body).axis(axis).sweep(way, {}, SweepKind::cut).run();
    halves.tool(body).axis(axis).sweep(part(way, 0, cut), {}, SweepKind::cut);
    halves.sweep(part(way, cut, 1), {}, SweepKind::cut).run();
    EXPECT_NEAR(whole.removed(), halves.removed(), 1e-4) << i;
    EXPECT_LT(difference(whole.model, halves.model), 2e-3) << i;
  }
}

/// The same job, seen in a mirror or turned about Z by a quarter.
struct View {
  const char* name;
  Vec3 (*of)(Vec3);
  bool mirrors;
};
const View kViews[] = {{"x",
                        [](Vec3 v) {
                          return Vec3{-v.x, v.y, v.z};
                        },
                        true},
                       {"y",
                        [](Vec3 v) {
                          return Vec3{v.x, -v.y, v.z};
                        },
                        true},
                       {"quarter",
                        [](Vec3 v) {
                          return Vec3{-v.y, v.x, v.z};
                        },
                        false}};

Sweep seen(const View& view, const Sweep& sweep) {
  Sweep other = sweep;
  if (const auto* way = std::get_if<StraightWay>(&sweep.way)) {
    other.way = StraightWay{view.of(way->from), view.of(way->to)};
  }
  return other;
}

TEST(Cutting, InAMirrorOrTurnedIsTheSameJob) {
  for (const View& view : kViews) {
    const Bounds box{{-9, -9, -6}, {9, 9, 4}};
    TriDexel plain(box_shape(box), 0.3, 1);
    TriDexel other(box_shape(box), 0.3, 1);
    std::vector<Sweep> sweeps = random_sweeps(plain, 21, 50, false);
    (void)random_sweeps(other, 21, 1, false);
    std::erase_if(sweeps,
                  [](const Sweep& s) { return !std::holds_alternative<StraightWay>(s.way); });
    std::vector<Sweep> others;
    for (const Sweep& sweep : sweeps) others.push_back(seen(view, sweep));
    std::vector<Outcome> a(sweeps.size());
    std::vector<Outcome> b(sweeps.size());
    plain.cut(sweeps, a);
    other.cut(others, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].removed.value(), b[i].removed.value()) << view.name << i;
    }
  }
}

TEST(Cutting, IsRefusedWithoutABodyOrAPlace) {
  TriDexel model(box_shape(kBox), 0.5, 1);
  const double none = std::numeric_limits<double>::quiet_NaN();
  const BodyId body = model.add_body(flat(4));
  EXPECT_TRUE(model.can_cut({StraightWay{{0, 0, 0}, {1, 2, 3}}, {0.6, 0, 0.8}, body}));
  EXPECT_FALSE(model.can_cut({StraightWay{{0, 0, 0}, {1, 2, none}}, {0, 0, 1}, body}));
  EXPECT_FALSE(model.can_cut({StraightWay{{0, 0, 0}, {1, 2, 3}}, {0, 0, 1}, body + 1}));
  EXPECT_FALSE(model.can_cut({StraightWay{}, {0, 0, 1}, model.add_body(Body{})}));
}

TEST(Cutting, NeedsNoMoreMemoryInTheLongRun) {
  TriDexel model(box_shape(kBox), 0.2, 1);
  const std::vector<Sweep> sweeps = random_sweeps(model, 31, 200, false);
  std::vector<Outcome> outcomes(sweeps.size());
  model.cut(sweeps, outcomes);
  const std::size_t bytes = model.bytes();
  model.cut(sweeps, outcomes);
  EXPECT_EQ(model.bytes(), bytes);
  EXPECT_LT(static_cast<double>(bytes), 4 * TriDexel::bytes_for(kBox, 0.2));
}

}  // namespace
}  // namespace kerf::stock::dexel::test
