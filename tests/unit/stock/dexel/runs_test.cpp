// Of dexels across the tool many sweeps are cut together: what they leave is what they leave one by
// one, to the last bit.
#include <functional>
#include <string>

#include "mill.hpp"

namespace kerf::stock::dexel::test {
namespace {

const Bounds kBox{{-8, -7, -5}, {8, 7, 3}};
constexpr int kPoints = 60;

struct Job {
  std::string name;
  Body body;
  Vec3 axis;
  std::function<Vec3(double, double)> place;  ///< of a raster, both from -1 to 1
  int rows = 12;
};

/// There and back, row by row.
std::vector<Sweep> raster(const Job& job, BodyId body) {
  std::vector<Sweep> sweeps;
  Vec3 tip = job.place(-1, -1);
  for (int row = 0; row < job.rows; ++row) {
    for (int i = 0; i < kPoints; ++i) {
      const int k = row % 2 == 0 ? i : kPoints - 1 - i;
      const Vec3 to = job.place(2.0 * k / (kPoints - 1) - 1, 2.0 * row / (job.rows - 1) - 1);
      sweeps.push_back({StraightWay{tip, to}, job.axis, body, SweepKind::cut,
                        static_cast<std::uint32_t>(sweeps.size() + 1)});
      tip = to;
    }
  }
  return sweeps;
}

std::vector<Job> jobs() {
  const auto wavy = [](double a, double b) {
    return Vec3{9 * a, 8 * b, -1 + std::sin(3 * a) * std::cos(2 * b)};
  };
  const auto crosswise = [](double a, double b) {
    return Vec3{8 * b, 9 * a, -1 + std::sin(3 * a) * std::cos(2 * b)};
  };
  const auto slanting = [](double a, double b) { return Vec3{6 * (a + b), 6 * (a - b), -2}; };
  const auto level = [](double a, double b) { return Vec3{5 * a, 4 * b, -2}; };
  // The same wall again and again: ends that are the same, and nearly so.
  const auto wall = [](double a, double b) { return Vec3{6 * a, 2 + 1e-6 * b, -2 - b}; };
  const auto wide_rows = [](double a, double b) { return Vec3{6 * a, 8 * b, -4}; };
  const Vec3 leaning = geometry::unit({0.3, -0.2, 1});
  return {{"wavy", ball(3), {0, 0, 1}, wavy},
          {"crosswise", ball(3), {0, 0, 1}, crosswise},
          {"slanting", ball(3), {0, 0, 1}, slanting},
          {"slanting flat", flat(3), {0, 0, 1}, slanting},
          {"pocket", flat(4), {0, 0, 1}, level},
          {"wall", flat(4), {0, 0, 1}, wall},
          {"wall from aside", flat(4), {1, 0, 0}, wall},
          {"bull", bull(4, 1), {0, 0, 1}, wavy, 5},
          {"pointed", pointed(4, 30), {0, 0, 1}, wavy},
          {"leaning ball", ball(3), leaning, wavy},
          {"leaning flat", flat(3), leaning, wavy},
          {"t-slot", t_slot(6, 2, 3), {0, 0, 1}, wavy, 5},
          {"lollipop", lollipop(4, 2), {0, 0, 1}, level, 5},
          {"far rows", ball(1), {0, 0, 1}, wide_rows, 5}};
}

struct Left {
  std::vector<TriDexel::TileState> tiles;
  std::vector<Outcome> outcomes;
};

Left cut(const Job& job, std::size_t at_once, unsigned threads) {
  TriDexel model(box_shape(kBox), 0.3, threads);
  const std::vector<Sweep> sweeps = raster(job, model.add_body(job.body));
  Left left;
  left.outcomes.resize(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); i += at_once) {
    const std::size_t count = std::min(at_once, sweeps.size() - i);
    model.cut(std::span(sweeps).subspan(i, count), std::span(left.outcomes).subspan(i, count));
  }
  for (int grid = 0; grid < 3; ++grid) {
    for (std::size_t i = 0; i < model.tiles(grid); ++i) left.tiles.push_back(model.save(grid, i));
  }
  return left;
}

bool has_contact(const Left& left) {
  return std::any_of(left.outcomes.begin(), left.outcomes.end(),
                     [](const Outcome& one) { return one.has_contact(); });
}

void expect_same(const Left& a, const Left& b, const std::string& name) {
  EXPECT_TRUE(a.tiles == b.tiles) << name;
  for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
    ASSERT_EQ(a.outcomes[i].removed, b.outcomes[i].removed) << name << i;
    ASSERT_EQ(a.outcomes[i].visited, b.outcomes[i].visited) << name << i;
    for (std::size_t p = 0; p < kToolParts; ++p) {
      ASSERT_EQ(a.outcomes[i].contacts[p].volume, b.outcomes[i].contacts[p].volume) << name << i;
      ASSERT_EQ(a.outcomes[i].contacts[p].at, b.outcomes[i].contacts[p].at) << name << i;
    }
  }
}

TEST(Runs, LeaveWhatSweepsLeaveOneByOne) {
  for (const Job& job : jobs()) {
    const Left one_by_one = cut(job, 1, 1);
    expect_same(one_by_one, cut(job, 100'000, 1), job.name);
    expect_same(one_by_one, cut(job, 97, 2), job.name);
  }
}

TEST(Runs, TellTheContactsOfShanks) {
  std::size_t with = 0;
  for (const Job& job : jobs()) with += has_contact(cut(job, 100'000, 1)) ? 1U : 0U;
  EXPECT_EQ(with, 2U);  // the neck of the T-slot cutter, and that of the lollipop
}

}  // namespace
}  // namespace kerf::stock::dexel::test
