// What holds for the moves of G71 and G72 whatever the shape: random ones, in all quadrants.
// KERF_TURNING_SHAPES=N tries N of them instead of some hundred.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "control/gcode/cycles/shape_check.hpp"
#include "random_shape.hpp"
#include "turning_bench.hpp"

namespace kerf::control {
namespace {

using geometry::Vec2;
using test::kSeed;
using test::Moves;
using test::Quadrant;
using test::RandomShape;
using test::ShapeDice;

constexpr double kTolerance = 1e-9;

unsigned cases() {
  const char* const wanted = std::getenv("KERF_TURNING_SHAPES");
  return wanted == nullptr ? 2000 : static_cast<unsigned>(std::atoi(wanted));
}

struct Case {
  RandomShape shape;
  RoughSettings settings;  // of no quadrant: the allowance is that of the shape's own frame
  bool pockets;
};

Case make_case(unsigned seed, bool pockets) {
  ShapeDice dice(seed);
  RandomShape shape = dice.shape(pockets);
  return {std::move(shape), dice.settings(), pockets};
}

struct Run {
  Moves moves;
  std::uint64_t passes;
};

Run run(const Case& one, const Quadrant& quadrant) {
  RoughSettings settings = one.settings;
  settings.travel = quadrant.travel();
  settings.allowance = quadrant.in_plane(settings.allowance);
  const auto passes = rough_passes(place(one.shape, quadrant, one.pockets), settings);
  Moves moves = test::moves_of(*passes);
  return {std::move(moves), passes->passes()};
}

// Moves as seen in the shape's own frame, without the allowance.
Moves in_frame(const Case& one, const Quadrant& quadrant, Moves moves) {
  for (TurningMove& move : moves) {
    move.to = quadrant.local(move.to) - one.settings.allowance;
    move.centre = quadrant.local(move.centre) - one.settings.allowance;
    move.clockwise = move.clockwise != quadrant.turns_over();
  }
  return moves;
}

// Calls what(case, quadrant, moves in the shape's frame, passes) for each of many random shapes,
// the quadrants in turn.
template <typename What>
void for_many(bool pockets, const What& what) {
  auto all = test::quadrants(false);
  if (!pockets) {
    for (const Quadrant& quadrant : test::quadrants(true)) all.push_back(quadrant);
  }
  const unsigned count = cases();
  for (unsigned i = 0; i < count; ++i) {
    const Case one = make_case(kSeed + i, pockets);
    const Quadrant& quadrant = all[i % all.size()];
    const Run found = run(one, quadrant);
    what(one, in_frame(one, quadrant, found.moves), found.passes);
    if (!testing::Test::HasFailure()) continue;
    FAIL() << "seed " << kSeed + i << ", depth " << one.settings.depth_mm << ", retreat "
           << one.settings.retreat_mm << "\n"
           << text(one.shape) << "\nmoves in its frame\n"
           << test::text(in_frame(one, quadrant, found.moves));
  }
}

class Roughing : public testing::TestWithParam<bool> {
 protected:
  static bool pockets() { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(OfBothTypes, Roughing, testing::Bool(),
                         [](const auto& type) { return type.param ? "TypeTwo" : "TypeOne"; });

TEST_P(Roughing, EndsWithTheShapeAndItsAllowance) {
  for_many(pockets(), [](const Case& one, const Moves& moves, std::uint64_t) {
    const auto& pieces = one.shape.pieces;
    ASSERT_GT(moves.size(), pieces.size() + 1);
    const TurningMove* move = &moves[moves.size() - 1 - pieces.size()];
    EXPECT_LE(length(move[-1].to - pieces.front().from), kTolerance);
    for (std::size_t i = 0; i < pieces.size(); ++i, ++move) {
      EXPECT_EQ(move->kind, TurningMove::Kind::feed);
      EXPECT_EQ(move->block, i + 1);
      EXPECT_LE(length(move->to - pieces[i].to), kTolerance);
      EXPECT_EQ(move->is_arc, pieces[i].is_arc);
      if (!move->is_arc) continue;
      EXPECT_EQ(move->clockwise, pieces[i].clockwise);
      EXPECT_LE(length(move->centre - pieces[i].centre), kTolerance);
    }
    EXPECT_LE(length(move->to + one.settings.allowance - Vec2{0, one.shape.start}), kTolerance);
  });
}

// How deep a point lies in the shape; walls may be touched.
double depth(const RandomShape& shape, Vec2 point) {
  if (point.u <= kTolerance) return 0;
  if (point.u > shape.end() + kTolerance) return INFINITY;
  return shape.lowest(point.u - kTolerance, std::min(point.u + kTolerance, shape.end())) - point.v;
}

Vec2 point_of(Vec2 from, const TurningMove& move, double share) {
  if (!move.is_arc) return from + share * (move.to - from);
  const double sweep = geometry::sweep_rad(from, move.to, move.centre, move.clockwise) * share;
  const double sine = std::sin(move.clockwise ? -sweep : sweep);
  const Vec2 arm = from - move.centre;
  return move.centre + std::cos(sweep) * arm + sine * geometry::left_of(arm);
}

TEST_P(Roughing, NeverGoesIntoTheShape) {
  for_many(pockets(), [](const Case& one, const Moves& moves, std::uint64_t) {
    Vec2 at = moves.front().to;
    // From the end of the shape the tool goes straight home, whatever it is like.
    for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
      for (int k = 1; k <= 8; ++k) {
        const Vec2 point = point_of(at, moves[i], k / 8.0);
        ASSERT_LE(depth(one.shape, point), 2 * kTolerance)
            << "move " << i << " at " << point.u << " " << point.v;
      }
      at = moves[i].to;
    }
  });
}

// Where a move passes over u, which is none of its ends; NAN where it does not.
double height_over(double u, Vec2 from, const TurningMove& move) {
  if ((from.u < u) == (move.to.u < u)) return NAN;
  if (!move.is_arc) return from.v + (u - from.u) / (move.to.u - from.u) * (move.to.v - from.v);
  return test::RandomPiece{from, move.to, true, move.clockwise, move.centre}.height(u);
}

// What stands over some places of the shape while passes take it off.
class Stock {
 public:
  Stock(const RandomShape& shape, unsigned seed) : shape_(shape) {
    test::SeededRandom random(seed);
    for (int i = 0; i < 24; ++i) places_.push_back({random.in(0, shape.end()), shape.start});
  }

  // Until the pass along the shape begins.
  void take(Vec2 from, const TurningMove& move) {
    for (Place& place : places_) {
      const double height = height_over(place.u, from, move);
      if (std::isnan(height)) continue;
      if (move.kind == TurningMove::Kind::rapid) {
        EXPECT_GE(height, place.top - kTolerance) << "rapid through the stock at " << place.u;
      }
      if (move.kind == TurningMove::Kind::feed) place.top = std::min(place.top, height);
    }
  }
  void expect_no_more_than(double depth) const {
    for (const Place& place : places_)
      EXPECT_LE(place.top - shape_.height(place.u), depth + kTolerance) << "left at " << place.u;
  }

 private:
  struct Place {
    double u;
    double top;
  };
  const RandomShape& shape_;
  std::vector<Place> places_;
};

TEST_P(Roughing, LeavesNoMoreThanOneLevelAndItsRapidsMeetNoStock) {
  for_many(pockets(), [](const Case& one, const Moves& moves, std::uint64_t passes) {
    Stock stock(one.shape, static_cast<unsigned>(passes));
    const std::size_t along = moves.size() - 1 - one.shape.pieces.size();
    for (std::size_t i = 1; i < along; ++i) {
      // Above a flat before P0 the program's own rapid block ends.
      if (moves[i].block != 0) stock.take(moves[i - 1].to, moves[i]);
    }
    stock.expect_no_more_than(one.settings.depth_mm);
  });
}

// The passes that it takes, found by looking at all of the shape for each: parts of a level are
// intervals of u, not pieces.
class PassCount {
 public:
  PassCount(const RandomShape& shape, double depth) : shape_(shape), depth_(depth) {}

  std::uint64_t below(double level, int number, double a, double b) {
    const double deepest = shape_.lowest(a, b);
    const double next = std::max(shape_.start - number * depth_, deepest);
    if (next >= level - kTolerance) return 0;
    std::uint64_t count = 0;
    const auto end_part = [&](double from, double to) {
      if (to - from > 1e-5) count += 1 + below(next, number + 1, from, to);
    };
    const auto all = shape_.crossings(next, a, b);
    double begin = a;
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (all[i] - all[i - 1] < kTolerance) continue;
      if (shape_.height((all[i] + all[i - 1]) / 2) <= next + kTolerance) continue;
      end_part(begin, all[i - 1]);
      begin = all[i];
    }
    end_part(begin, b);
    return count;
  }

 private:
  const RandomShape& shape_;
  double depth_;
};

TEST_P(Roughing, TakesAsManyPassesAsThereAreLevels) {
  for_many(pockets(), [](const Case& one, const Moves&, std::uint64_t passes) {
    const double levels = (one.shape.start - one.shape.first()) / one.settings.depth_mm;
    const std::uint64_t wanted = one.pockets
                                     ? PassCount(one.shape, one.settings.depth_mm)
                                           .below(one.shape.start, 1, 0, one.shape.end())
                                     : static_cast<std::uint64_t>(std::ceil(levels - kTolerance));
    EXPECT_EQ(passes, wanted);
  });
}

// To the last bit.
void expect_mirrored(const Moves& moves, const Moves& mirrored, const Quadrant& quadrant) {
  ASSERT_EQ(moves.size(), mirrored.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    ASSERT_EQ(quadrant.in_plane(moves[i].to), mirrored[i].to) << i;
    ASSERT_EQ(moves[i].kind, mirrored[i].kind) << i;
    ASSERT_EQ(moves[i].block, mirrored[i].block) << i;
    ASSERT_EQ(moves[i].is_arc, mirrored[i].is_arc) << i;
    if (!moves[i].is_arc) continue;
    ASSERT_EQ(moves[i].clockwise, mirrored[i].clockwise != quadrant.turns_over()) << i;
    ASSERT_EQ(quadrant.in_plane(moves[i].centre), mirrored[i].centre) << i;
  }
}

TEST_P(Roughing, OfMirroredShapesIsMirrored) {
  const unsigned count = cases() / 8;
  for (unsigned i = 0; i < count; ++i) {
    const Case one = make_case(kSeed + i, pockets());
    const Moves moves = run(one, {}).moves;
    for (const bool exchanged : {false, true}) {
      if (exchanged && pockets()) continue;
      for (const Quadrant& quadrant : test::quadrants(exchanged))
        expect_mirrored(moves, run(one, quadrant).moves, quadrant);
    }
    if (HasFailure()) FAIL() << "seed " << kSeed + i << "\n" << text(one.shape);
  }
}

// Any pieces whatever, from point to point of a coarse grid.
TurningShape random_pieces(test::SeededRandom& random) {
  const auto point = [&] { return Vec2{0.5 * random.count(-8, 8), 0.5 * random.count(-8, 8)}; };
  TurningShape shape{.start = point(),
                     .approach_is_rapid = random.coin(),
                     .both_axes = random.coin(),
                     .pieces = {}};
  Vec2 at = point();
  for (int i = random.count(0, 8); i > 0; --i) {
    const Vec2 to = random.count(0, 5) == 0 ? at : point();
    shape.pieces.push_back({.from = at,
                            .to = to,
                            .is_arc = random.coin(),
                            .clockwise = random.coin(),
                            .centre = point()});
    at = to;
  }
  return shape;
}

TEST(RoughingOfAnything, HasAnEndAndNumbersForPoints) {
  test::SeededRandom random(kSeed);
  for (unsigned i = cases(); i > 0; --i) {
    const TurningShape shape = random_pieces(random);
    const Travel travel = random.coin() ? Travel::along_z : Travel::along_x;
    const auto passes =
        rough_passes(shape, {.travel = travel, .depth_mm = 0.25 * random.count(1, 9)});
    const Moves moves = test::moves_of(*passes, 10'000);
    for (const TurningMove& move : moves) {
      ASSERT_LE(std::fabs(move.to.u), 100) << test::text(moves);
      ASSERT_LE(std::fabs(move.to.v), 100) << test::text(moves);
    }
    ASSERT_EQ(moves.back().to, shape.start);
    (void)check_shape(shape, travel, {});
  }
}

}  // namespace
}  // namespace kerf::control
