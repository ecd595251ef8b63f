// Nose radius compensation against a second method (docs/dialect/turning.md, nose radius): the
// corners of the centre's path are where the signed distances from both pieces are the radius,
// found by Newton's method, and the tip is the centre and the vector of its direction.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/vec2.hpp"
#include "machine_run.hpp"
#include "program_text.hpp"
#include "seeded_random.hpp"

namespace kerf::test {
namespace {

using geometry::Vec2;

constexpr int kContours = 600;
constexpr int kPieces = 7;
constexpr double kTolerance = 1e-6;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLeastTurn = 3 * kDegree;
constexpr double kMostTurn = 125 * kDegree;

/// From `from` to `to` in (Z, X as a radius), mm; `turn` is 0 of a line, 1 counterclockwise, -1
/// clockwise.
struct Piece {
  Vec2 from{};
  Vec2 to{};
  int turn = 0;
  double radius = 0;
  Vec2 centre{};
};

Vec2 tangent(const Piece& piece, Vec2 at) {
  if (piece.turn == 0) return geometry::unit(piece.to - piece.from);
  return piece.turn * geometry::left_of(geometry::unit(at - piece.centre));
}

// How far a point lies to the left of a piece that goes on beyond its ends, and the direction in
// which that grows.
double distance_to_left(const Piece& piece, Vec2 p) {
  if (piece.turn == 0) return geometry::cross(tangent(piece, piece.from), p - piece.from);
  return piece.turn *
         (geometry::length(piece.from - piece.centre) - geometry::length(p - piece.centre));
}

Vec2 growth(const Piece& piece, Vec2 p) {
  if (piece.turn == 0) return geometry::left_of(tangent(piece, piece.from));
  return -piece.turn * geometry::unit(p - piece.centre);
}

// The point at the distance `d` to the left of both pieces that is near to `p`.
Vec2 meeting(const Piece& a, const Piece& b, double d, Vec2 p) {
  for (int i = 0; i < 60; ++i) {
    const Vec2 wrong{distance_to_left(a, p) - d, distance_to_left(b, p) - d};
    const Vec2 ga = growth(a, p);
    const Vec2 gb = growth(b, p);
    const double det = geometry::cross(ga, gb);
    p = p - (1 / det) * Vec2{wrong.u * gb.v - wrong.v * ga.v, wrong.v * ga.u - wrong.u * gb.u};
  }
  return p;
}

double turn_between(const Piece& a, const Piece& b) {
  const Vec2 d1 = tangent(a, a.to);
  const Vec2 d2 = tangent(b, b.from);
  return std::atan2(geometry::cross(d1, d2), geometry::dot(d1, d2));
}

/// A move of the tip. `turn` as that of a piece.
struct Move {
  Vec2 to{};
  int turn = 0;
  Vec2 centre{};
};

// The path of the centre, built from the contour's pieces; `d` > 0 lies to the left of them.
class CentrePath {
 public:
  CentrePath(const std::vector<Piece>& contour, double d) : d_(d) {
    go(beside(contour.front(), contour.front().from));
    for (std::size_t i = 0; i + 1 < contour.size(); ++i) corner(contour[i], contour[i + 1]);
    along(contour.back(), beside(contour.back(), contour.back().to));
  }
  [[nodiscard]] const std::vector<Move>& moves() const { return moves_; }

 private:
  // Up to 90 degrees the offset curves meet; beyond, straight moves go round.
  void corner(const Piece& piece, const Piece& next) {
    const double turn = turn_between(piece, next);
    if (turn * d_ <= 0 && std::fabs(turn) > 90 * kDegree) return go_round(piece, next);
    const Vec2 mitre =
        geometry::left_of(tangent(piece, piece.to)) + geometry::left_of(tangent(next, next.from));
    const Vec2 guess = piece.to + (2 * d_ / geometry::dot(mitre, mitre)) * mitre;
    along(piece, meeting(piece, next, d_, guess));
  }
  // As long as the radius on both sides; arcs are left and reached on their circles.
  void go_round(const Piece& piece, const Piece& next) {
    if (piece.turn != 0) along(piece, beside(piece, piece.to));
    go(beside(piece, piece.to) + std::fabs(d_) * tangent(piece, piece.to));
    go(beside(next, next.from) - std::fabs(d_) * tangent(next, next.from));
    if (next.turn != 0) go(beside(next, next.from));
  }
  [[nodiscard]] Vec2 beside(const Piece& piece, Vec2 at) const {
    return at + d_ * geometry::left_of(tangent(piece, at));
  }
  void go(Vec2 to) { moves_.push_back({.to = to}); }
  void along(const Piece& piece, Vec2 to) { moves_.push_back({to, piece.turn, piece.centre}); }

  double d_;
  std::vector<Move> moves_;
};

// Directions of the tip as the table of the manuals has them: along X, then along Z.
constexpr std::array<std::array<int, 2>, 10> kDirections = {
    {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}, {0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 0}}};

std::vector<Move> tip_path(std::vector<Move> path, double r, std::size_t direction) {
  const Vec2 to_tip{r * kDirections[direction][1], r * kDirections[direction][0]};
  for (Move& move : path) {
    move.to = move.to + to_tip;
    move.centre = move.centre + to_tip;
  }
  return path;
}

// As a program can write it: X to the thousandth of a diameter.
Vec2 writable(Vec2 p) { return {thousandths(p.u), thousandths(2 * p.v) / 2}; }

std::string words(Vec2 p) { return "X" + decimal(2 * p.v) + "Z" + decimal(p.u); }

Piece random_piece(SeededRandom& random, Vec2 from) {
  Piece piece{.from = from};
  const double heading = random.in(0, 360) * kDegree;
  piece.turn = random.count(-1, 1);
  piece.radius = thousandths(random.in(4, 15));
  const double most = piece.turn == 0 ? 12 : 1.6 * piece.radius;
  const double length = random.in(4, most);
  piece.to = writable(from + length * Vec2{std::cos(heading), std::sin(heading)});
  const Vec2 chord = piece.to - from;
  const double half = geometry::length(chord) / 2;
  const double height = std::sqrt(piece.radius * piece.radius - half * half);
  piece.centre =
      from + 0.5 * chord + piece.turn * height * geometry::left_of(geometry::unit(chord));
  return piece;
}

bool follows(const Piece& before, const Piece& piece) {
  const double turn = std::fabs(turn_between(before, piece));
  return turn > kLeastTurn && turn < kMostTurn && std::fabs(turn - 90 * kDegree) > 1e-3;
}

std::vector<Piece> random_contour(SeededRandom& random) {
  std::vector<Piece> contour{random_piece(random, {-150, 100})};
  while (contour.size() < kPieces) {
    const Piece piece = random_piece(random, contour.back().to);
    if (follows(contour.back(), piece)) contour.push_back(piece);
  }
  return contour;
}

constexpr Vec2 kStart{-100, 100};

// Up to G41 or G42, which the next word follows.
std::string head(bool left, double r, std::size_t direction) {
  return "O1\nG99F.2\n#2901=" + decimal(r) + "\n#2301=" + std::to_string(direction) + "\nG00" +
         words(kStart) + "T0101\n" + (left ? "G41" : "G42");
}

std::string blocks(const std::vector<Piece>& contour) {
  std::string text;
  for (const Piece& piece : contour) {
    text += piece.turn == 0 ? "G01" : piece.turn > 0 ? "G03" : "G02";
    text += words(piece.to);
    if (piece.turn != 0) text += "R" + decimal(piece.radius);
    text += "\n";
  }
  return text;
}

std::string program_along(const std::vector<Piece>& contour, bool left, double r,
                          std::size_t direction) {
  return head(left, r, direction) + words(contour.front().from) + "\n" + blocks(contour) +
         "G40G00" + words(kStart) + "\nM30\n";
}

Move move_of(const motion::Motion& motion) {
  const base::TipPoint& to = *motion::target_of(motion);
  Move move{.to = {to.values[1], to.values[0]}};
  if (const auto* const arc = std::get_if<motion::Arc>(&motion.action)) {
    move.turn = arc->direction == motion::Direction::clockwise ? -1 : 1;
    move.centre = {arc->center[0], arc->center[1]};
  }
  return move;
}

void expect_move(const Move& got, const Move& wanted) {
  EXPECT_LT(geometry::length(got.to - wanted.to), kTolerance);
  EXPECT_EQ(got.turn, wanted.turn);
  if (wanted.turn == 0) return;
  EXPECT_LT(geometry::length(got.centre - wanted.centre), kTolerance);
}

TEST(NoseRadius, TheTipGoesAsAnIndependentOffsetOfTheContourSays) {
  SeededRandom random(kSeed + 40);
  for (int i = 0; i < kContours; ++i) {
    const std::vector<Piece> contour = random_contour(random);
    const bool left = random.coin();
    const auto direction = static_cast<std::size_t>(i % 10);
    const double r = thousandths(random.in(0.1, 0.8));
    const std::string program = program_along(contour, left, r, direction);
    const RunResult result = run_program(program, {.machine = "lathe2"});
    ASSERT_EQ(result.alarm, "") << program;
    const std::vector<motion::Motion> got = moves_of(result);
    const std::vector<Move> wanted =
        tip_path(CentrePath(contour, left ? r : -r).moves(), r, direction);
    ASSERT_EQ(got.size(), wanted.size() + 2) << program << text_of(got);
    for (std::size_t k = 0; k < wanted.size(); ++k) expect_move(move_of(got[k + 1]), wanted[k]);
    expect_move(move_of(got.back()), {.to = kStart});
    ASSERT_FALSE(HasFailure()) << program << text_of(got);
  }
}

constexpr int kRoughed = 200;
constexpr double kLeastArea = 20;  // mm²: less does not say on which side the start lies

// Of the corners of the contour and the start, counterclockwise positive, by the trapezoids below.
double area_round(const std::vector<Piece>& contour) {
  std::vector<Vec2> corners{kStart, contour.front().from};
  for (const Piece& piece : contour) corners.push_back(piece.to);
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 b = corners[(i + 1) % corners.size()];
    area += (a.u - b.u) * (a.v + b.v) / 2;
  }
  return area;
}

std::string roughing_along(const std::vector<Piece>& contour, const std::string& begin,
                           const std::string& cycle, Vec2 allowance) {
  return begin + "\n" + cycle + "P10Q20U" + decimal(2 * allowance.v) + "W" + decimal(allowance.u) +
         "\nN10G00" + words(contour.front().from) + "\n" + blocks(contour) + "N20\nM30\n";
}

// The moves that the blocks of the shape are told to have made.
std::vector<Move> along_shape(const RunResult& result, std::uint32_t cycle_line) {
  std::vector<Move> moves;
  for (const motion::Motion& motion : moves_of(result)) {
    if (motion.block.line > cycle_line) moves.push_back(move_of(motion));
  }
  return moves;
}

TEST(NoseRadius, RoughingWithTheNoseEndsOnAnIndependentOffsetAndItsAllowance) {
  SeededRandom random(kSeed + 41);
  for (int i = 0; i < kRoughed; ++i) {
    const std::vector<Piece> contour = random_contour(random);
    if (std::fabs(area_round(contour)) < kLeastArea) continue;
    const bool left = area_round(contour) > 0;
    const auto direction = static_cast<std::size_t>(i % 10);
    const double r = thousandths(random.in(0.1, 0.8));
    const Vec2 allowance = writable({random.in(-0.3, 0.3), random.in(-0.3, 0.3)});
    const std::string cycle = i % 2 == 0 ? "G71U3.R.5\nG71" : "G73U2.W1.R2\nG73";
    const std::string program = roughing_along(contour, head(left, r, direction), cycle, allowance);
    const RunResult result =
        run_program(program, {.machine = "lathe2", .parameters = {{"cycle_nose", "1"}}});
    ASSERT_EQ(result.alarm, "") << program;
    const std::vector<Move> wanted =
        tip_path(CentrePath(contour, left ? r : -r).moves(), r, direction);
    const std::vector<Move> got = along_shape(result, 8);
    ASSERT_GE(got.size(), wanted.size()) << program;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      Move move = got[got.size() - wanted.size() + k];
      move.to = move.to - allowance;
      move.centre = move.centre - allowance;
      expect_move(move, wanted[k]);
    }
    ASSERT_FALSE(HasFailure()) << program;
  }
}

}  // namespace
}  // namespace kerf::test
