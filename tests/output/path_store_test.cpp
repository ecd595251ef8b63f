#include "output/picture/internal/path_store.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

constexpr Pen kCut{Trace::cut, 1};

// Feeds a polyline.
class Pencil {
 public:
  explicit Pencil(PathStore& store) : store_(store) {}
  void to(const Point3& next, Pen pen = kCut) {
    store_.line(pen, at_, next);
    at_ = next;
  }

 private:
  PathStore& store_;
  Point3 at_{};
};

// In each coordinate, as the store promises: the smallest over the segments of the largest.
double distance(const Point3& p, const Path& path) {
  double best = 1e300;
  for (std::size_t s = 0; s < path.strokes.size(); ++s) {
    const auto vertices = path.vertices_of(s);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const Point3 &a = vertices[i - 1].at, &b = vertices[i].at;
      const Point3 along = b - a, way = p - a;
      double dot = 0, square = 0;
      for (std::size_t k = 0; k < 3; ++k) dot += along[k] * way[k], square += along[k] * along[k];
      const double t = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
      double furthest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        furthest = std::max(furthest, std::abs(way[k] - t * along[k]));
      }
      best = std::min(best, furthest);
    }
  }
  return best;
}

TEST(PathStore, KeepsASmallPathExactly) {
  PathStore store;
  Pencil pencil(store);
  for (int i = 1; i <= 1000; ++i) pencil.to({0.001 * i, std::sin(i), 0});
  const Path path = store.path();
  EXPECT_EQ(store.tolerance(), 0);
  ASSERT_EQ(path.strokes.size(), 1U);
  ASSERT_EQ(path.vertices.size(), 1001U);
  EXPECT_EQ(path.vertices.back().at, (Point3{1, std::sin(1000), 0}));
}

TEST(PathStore, KeepsArcsWhileTheyAreFew) {
  PathStore store;
  motion::Arc arc;
  store.arc(kCut, ArcPath({10, 0, 0}, arc, {-10, 0, 0}, {0, 0}));
  EXPECT_EQ(store.path().arcs.size(), 1U);
  for (std::size_t i = 0; i < PathStore::kBudget; ++i) {
    store.arc(kCut, ArcPath({-10, 0, 0}, arc, {-10, 0, 0}, {0, 0}));
  }
  EXPECT_TRUE(store.path().arcs.empty());
  EXPECT_GT(store.path().vertices.size(), 50U);
}

TEST(PathStore, NeverHoldsMoreThanItsBudget) {
  PathStore store;
  Pencil pencil(store);
  testing::Random random(7);
  for (std::size_t i = 0; i < 6 * PathStore::kBudget; ++i) {
    const double x = 100 * random.next(), y = 100 * random.next();
    pencil.to({x, y, 0}, i % 3 == 0 ? Pen{} : kCut);
    if (i % 5000 == 0) {
      ASSERT_LE(store.path().vertices.size(), PathStore::kBudget + 1);
    }
  }
}

/// The store has left points out, and each sample is as near to the path that it has kept as it
/// says.
void expect_path_near(const PathStore& store, const std::vector<Point3>& samples) {
  ASSERT_GT(store.tolerance(), 0);
  const Path path = store.path();
  for (const Point3& sample : samples) {
    ASSERT_LE(distance(sample, path), PathStore::kMostOff * store.tolerance());
  }
}

TEST(PathStore, EveryPointStaysWithinTheStatedDistanceOfThePathKept) {
  PathStore store;
  Pencil pencil(store);
  std::vector<Point3> samples;
  for (int i = 1; i <= 300'000; ++i) {  // a spiral over a wavy surface, cut over and over
    const double angle = 0.01 * i, radius = 20 + 15 * std::sin(0.003 * i);
    const Point3 next{radius * std::cos(angle), radius * std::sin(angle), std::sin(0.1 * angle)};
    pencil.to(next);
    if (i % 997 == 0) samples.push_back(next);
  }
  EXPECT_LT(store.tolerance(), 0.1);
  expect_path_near(store, samples);
}

TEST(PathStore, ALongHatchStaysWithinTheStatedDistanceOfThePathKept) {
  PathStore store;
  Pencil pencil(store);
  testing::Random random(2);
  std::vector<Point3> samples;
  for (int i = 1; i <= 200'000; ++i) {  // lines of different lengths, ever closer together
    const double y = 100 * std::sqrt(i / 200'000.0), x = i % 2 == 0 ? 0 : 5 + random.next();
    pencil.to({x, y, 0});
    if (i % 401 == 0) samples.push_back({x, y, 0});
  }
  expect_path_near(store, samples);
}

TEST(PathStore, ThePathKeptEndsWhereThePenIs) {
  PathStore store;
  Pencil pencil(store);
  for (int i = 1; i <= 70'000; ++i) pencil.to({0.01 * i, std::sin(0.01 * i), 0});
  ASSERT_GT(store.tolerance(), 0);
  EXPECT_EQ(store.path().vertices.back().at, (Point3{700, std::sin(700.0), 0}));
  pencil.to({800, 0, 0});
  EXPECT_EQ(store.path().vertices.back().at, (Point3{800, 0, 0}));
}

TEST(SegmentSet, KnowsOnlySegmentsWhoseEndsShareTheirCells) {
  constexpr double kCell = 0.5;
  SegmentSet set;
  set.clear(kCell);
  testing::Random random(4);
  std::vector<std::pair<Point3, Point3>> known;
  std::size_t repeated = 0;
  const auto near = [](const Point3& a, const Point3& b) {
    return std::ranges::max(a - b) <= kCell && std::ranges::max(b - a) <= kCell;
  };
  for (int i = 0; i < 3000; ++i) {
    const Point3 a{2 * random.next() - 1, 2 * random.next() - 1, 0};
    const Point3 b{2 * random.next() - 1, 0, 0};
    if (set.insert(a, b, 1)) {
      known.emplace_back(a, b);
      continue;
    }
    ++repeated;
    EXPECT_TRUE(std::ranges::any_of(known, [&](const auto& segment) {
      const auto& [c, d] = segment;
      return (near(a, c) && near(b, d)) || (near(a, d) && near(b, c));
    }));
  }
  EXPECT_GT(repeated, 2500U);
}

TEST(SegmentSet, DoesNotMindTheDirectionButTheLabel) {
  SegmentSet set;
  set.clear(1);
  EXPECT_TRUE(set.insert({0, 0, 0}, {9, 9, 9}, 1));
  EXPECT_FALSE(set.insert({9, 9, 9}, {0, 0, 0}, 1));
  EXPECT_TRUE(set.insert({9, 9, 9}, {0, 0, 0}, 2));
}

TEST(SegmentSet, WhenFullTakesEveryOtherSegmentForNew) {
  SegmentSet set;
  set.clear(1);
  for (std::size_t i = 0; i < SegmentSet::kCapacity; ++i) {
    ASSERT_TRUE(set.insert({static_cast<double>(i), 0, 0}, {0, 5, 0}, 1));
  }
  EXPECT_FALSE(set.insert({3, 0, 0}, {0, 5, 0}, 1));
  EXPECT_TRUE(set.insert({0, 0, 7}, {0, 5, 0}, 1));
  EXPECT_TRUE(set.insert({0, 0, 7}, {0, 5, 0}, 1));
}

TEST(PathStore, AContourCutAMillionTimesIsKeptOnce) {
  PathStore store;
  Pencil pencil(store);
  for (int i = 0; i < 250'000; ++i) {
    for (const Point3& corner : {Point3{50, 0, 0}, {50, 30, 0}, {0, 30, 0}, {0, 0, 0}}) {
      pencil.to(corner);
    }
  }
  EXPECT_LT(store.path().vertices.size(), 20U);
}

TEST(PathStore, EachPenKeepsItsOwnStrokes) {
  PathStore store;
  Pencil pencil(store);
  pencil.to({10, 0, 0}, Pen{});
  pencil.to({20, 0, 0}, kCut);
  pencil.to({30, 0, 0}, kCut);
  pencil.to({40, 0, 0}, Pen{Trace::cut, 2});
  const Path path = store.path();
  ASSERT_EQ(path.strokes.size(), 3U);
  EXPECT_EQ(path.strokes[1].pen, kCut);
  EXPECT_EQ(path.vertices_of(1).front().at, (Point3{10, 0, 0}));
  EXPECT_EQ(path.vertices_of(1).back().at, (Point3{30, 0, 0}));
}

}  // namespace
}  // namespace kerf::output::plot
