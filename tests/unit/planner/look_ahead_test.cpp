#include "planner/look_ahead.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr double kPrinted = 5.001e-7;  // six decimals
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Cells that follow each other on one path; the axes are at rest before the first and behind the
/// last.
class Cells {
 public:
  void add(double length, const PathLimits& limits, bool stop = false) {
    Cell& cell = ring_.push();
    cell = {};
    cell.end = length;
    cell.limits = limits;
    cell.stop = stop;
  }
  /// A speed that is not exceeded between two cells: a cell of no length.
  void cap(double speed, double acceleration) { add(0, {speed, acceleration, kInfinite}); }

  [[nodiscard]] const Ring<Cell>& ring() const { return ring_; }

  [[nodiscard]] std::vector<Section> planned() const {
    LookAhead look_ahead(std::isfinite(ring_[0].limits.jerk));
    look_ahead.absorb(ring_);
    EXPECT_TRUE(look_ahead.plan(true));
    std::vector<Section> sections;
    while (look_ahead.has_planned()) look_ahead.take(sections.emplace_back());
    return sections;
  }

 private:
  Ring<Cell> ring_{4096};
};

double time_of(const std::vector<Section>& sections) {
  double time_s = 0;
  for (const Section& section : sections)
    time_s += Profile(section.length, section.entry, section.exit, section.limits).duration_s();
  return time_s;
}

struct Row {
  std::vector<double> lengths, speeds, junctions;
  double acceleration;
  std::vector<double> nodes;
  double time_s;
};

TEST(LookAhead, PlansTheSpeedsOfTheTable) {
  const Row rows[] = {
      {{10, 2, 2, 10, 5},
       {100, 100, 60, 100, 30},
       {20, 15, 50, 12},
       800,
       {0, 20, 15, 50, 12, 0},
       0.677830},
      {{1, 1, 1, 1, 1, 1},
       {100, 100, 100, 100, 100, 100},
       {100, 100, 100, 100, 100},
       500,
       {0, 31.622777, 44.721360, 54.772256, 44.721360, 31.622777, 0},
       0.219089},
  };
  for (const Row& row : rows) {
    Cells cells;
    for (std::size_t i = 0; i < row.lengths.size(); ++i) {
      if (i > 0) cells.cap(row.junctions[i - 1], row.acceleration);
      cells.add(row.lengths[i], {row.speeds[i], row.acceleration, kInfinite},
                i + 1 == row.lengths.size());
    }
    const std::vector<Section> sections = cells.planned();
    std::vector<double> nodes{sections.front().entry};
    for (const Section& section : sections) {
      if (section.length > 0) nodes.push_back(section.exit);
    }
    ASSERT_EQ(nodes.size(), row.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i], row.nodes[i], kPrinted);
    EXPECT_NEAR(time_of(sections), row.time_s, kPrinted);
  }
}

Cells random_cells(SeededRandom& random, bool jerk_limited) {
  Cells cells;
  const int count = random.count(1, 60);
  for (int i = 0; i < count; ++i) {
    PathLimits limits{random.size(1, 500), random.size(10, 1e4), kInfinite};
    if (jerk_limited) limits.jerk = random.size(1e3, 1e6);
    cells.add(random.size(0.001, 10), limits, i + 1 == count || random.count(0, 19) == 0);
  }
  return cells;
}

// Against the definition: by relaxation until nothing changes, the highest speeds from which each
// neighbour can be reached.
TEST(LookAhead, WithoutJerkTheSpeedsAreTheHighestThatNeighboursReach) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    const Cells cells = random_cells(random, false);
    const Ring<Cell>& ring = cells.ring();
    std::vector<double> nodes(ring.size() + 1, kInfinite);
    nodes.front() = 0;
    for (std::uint64_t n = 0; n < ring.end(); ++n) {
      nodes[n] = std::min(nodes[n], ring[n].limits.velocity);
      nodes[n + 1] = ring[n].stop ? 0 : ring[n].limits.velocity;
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint64_t n = 0; n < ring.end(); ++n) {
        const double more = 2 * ring[n].limits.acceleration * ring[n].length();
        const auto lower = [&](double& speed, double other) {
          const double reach = std::sqrt(other * other + more);
          if (reach < speed * (1 - 1e-15)) {
            speed = reach;
            changed = true;
          }
        };
        lower(nodes[n], nodes[n + 1]);
        lower(nodes[n + 1], nodes[n]);
      }
    }
    const std::vector<Section> sections = cells.planned();
    ASSERT_EQ(sections.size(), ring.size());
    for (std::size_t n = 0; n < sections.size(); ++n) {
      ASSERT_NEAR(sections[n].entry, nodes[n], 1e-9 * (1 + nodes[n])) << i;
      ASSERT_NEAR(sections[n].exit, nodes[n + 1], 1e-9 * (1 + nodes[n + 1])) << i;
    }
  }
}

// Each section is held within the limits of the cells that it covers, goes on at the speed of the
// one before, and can be driven.
TEST(LookAhead, WithJerkSectionsJoinAndNoCellIsDrivenTooFast) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    const Cells cells = random_cells(random, true);
    const Ring<Cell>& ring = cells.ring();
    double speed = 0;
    std::uint64_t n = 0;
    for (const Section& section : cells.planned()) {
      ASSERT_NEAR(section.entry, speed, 1e-9 * (1 + speed)) << i;
      double length = 0;
      for (std::uint64_t k = 0; k < section.cells; ++k, ++n) {
        length += ring[n].length();
        ASSERT_LE(section.limits.velocity, ring[n].limits.velocity) << i;
        ASSERT_LE(section.limits.acceleration, ring[n].limits.acceleration) << i;
        ASSERT_LE(section.limits.jerk, ring[n].limits.jerk) << i;
        ASSERT_EQ(ring[n].stop, section.stop && k + 1 == section.cells) << i;
      }
      ASSERT_NEAR(section.length, length, 1e-9) << i;
      ASSERT_LE(std::max(section.entry, section.exit), section.limits.velocity * (1 + 1e-9)) << i;
      ASSERT_LE(ramp_length(section.entry, section.exit, section.limits),
                section.length * (1 + 1e-9) + 1e-9)
          << i;
      speed = section.exit;
      if (section.stop) {
        ASSERT_EQ(section.exit, 0) << i;
      }
    }
    ASSERT_EQ(n, ring.end()) << i;
  }
}

// Cells that come one by one: the plan may be slower than that of all, never impossible.
TEST(LookAhead, WhatIsFinalWhileMoreMayFollowCanBeDriven) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const Cells cells = random_cells(random, false);
    LookAhead early(false);
    Ring<Cell> known(4096);
    std::vector<Section> sections;
    for (std::uint64_t n = 0; n < cells.ring().end(); ++n) {
      known.push(cells.ring()[n]);
      early.absorb(known);
      ASSERT_TRUE(early.plan(n + 1 == cells.ring().end()));
      while (early.has_planned()) early.take(sections.emplace_back());
    }
    double speed = 0;
    for (const Section& section : sections) {
      ASSERT_NEAR(section.entry, speed, 1e-9 * (1 + speed)) << i;
      ASSERT_LE(ramp_length(section.entry, section.exit, section.limits),
                section.length * (1 + 1e-9) + 1e-9);
      speed = section.exit;
    }
    ASSERT_EQ(speed, 0) << i;
    ASSERT_EQ(sections.size(), cells.ring().size()) << i;
  }
}

TEST(LookAhead, WithJerkARampRunsThroughManyCells) {
  Cells one;
  one.add(100, {100, 1000, 10000}, true);
  Cells many;
  for (int i = 0; i < 1000; ++i) many.add(0.1, {100, 1000, 10000}, i == 999);
  EXPECT_NEAR(time_of(many.planned()), time_of(one.planned()), 1e-9);
  EXPECT_NEAR(time_of(one.planned()), 1.2, 1e-9);
}

}  // namespace
}  // namespace kerf::planner
