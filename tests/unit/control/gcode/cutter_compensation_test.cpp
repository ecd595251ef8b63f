// Properties of cutter compensation on seeded random contours (docs/dialect.md §9).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/arc.hpp"
#include "geometry/vec2.hpp"
#include "machine_run.hpp"
#include "program_text.hpp"
#include "seeded_random.hpp"

namespace kerf::test {
namespace {

using geometry::Vec2;

constexpr int kContours = 300;
constexpr double kTolerance = 1e-6;
constexpr double kPi = std::numbers::pi;
const std::string kHead = "O1\nG21G90G17G94F500\n";

/// A closed contour with its corners in counterclockwise order, to the thousandth of a millimetre.
using Contour = std::vector<Vec2>;

Vec2 corner(const Contour& contour, std::size_t i) { return contour[i % contour.size()]; }

Vec2 middle_of(Vec2 a, Vec2 b) {
  return {thousandths((a.u + b.u) / 2), thousandths((a.v + b.v) / 2)};
}

// The middle of the last edge becomes a corner, the last one: there the tool comes and goes. (To
// the thousandth it is not quite in the middle, so it does change the contour.)
Contour with_entry(Contour contour) {
  contour.push_back(middle_of(contour.back(), contour.front()));
  return contour;
}

// Corners on an ellipse: convex whatever they are, once rounded, as long as they lie well apart.
Contour random_convex(SeededRandom& random) {
  for (;;) {
    const double a = random.in(20, 100);
    const double b = random.in(20, 100);
    const double tilt = random.in(0, kPi);
    std::vector<double> angles(static_cast<std::size_t>(random.count(3, 9)));
    for (double& angle : angles) angle = random.in(0, 2 * kPi);
    std::sort(angles.begin(), angles.end());
    Contour contour;
    for (const double angle : angles) {
      const Vec2 p{a * std::cos(angle), b * std::sin(angle)};
      contour.push_back({thousandths(p.u * std::cos(tilt) - p.v * std::sin(tilt)),
                         thousandths(p.u * std::sin(tilt) + p.v * std::cos(tilt))});
    }
    bool good = true;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 d1 = corner(contour, i + 1) - corner(contour, i);
      const Vec2 d2 = corner(contour, i + 2) - corner(contour, i + 1);
      good &= geometry::length(d1) > 1 && geometry::cross(d1, d2) > 0;
    }
    if (good) return with_entry(contour);
  }
}

// A star: every second corner lies inside.
Contour random_star(SeededRandom& random) {
  Contour contour;
  const int points = random.count(4, 8);
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = kPi * i / points + random.in(-0.1, 0.1);
    const double r = i % 2 == 0 ? random.in(60, 100) : random.in(30, 45);
    contour.push_back({thousandths(r * std::cos(angle)), thousandths(r * std::sin(angle))});
  }
  return with_entry(contour);
}

// The other way round, with the same last corner.
Contour reversed(Contour contour) {
  std::reverse(contour.begin(), contour.end() - 1);
  return contour;
}

// The tool comes to the last corner from outside, goes round once, and leaves the way it came.
std::string program_round(const Contour& contour, const std::string& side, Vec2 shift = {}) {
  const Vec2 entry = contour.back();
  const Vec2 outside = entry + 60.0 * geometry::unit(entry);
  const auto at = [&](Vec2 point) { return xy(point.u + shift.u, point.v + shift.v) + "\n"; };
  std::string text = "G00" + at(outside) + side + "D1G01" + at(entry);
  for (const Vec2 point : contour) text += at(point);
  return text + "G40" + at(outside);
}

RunResult run(const std::string& blocks, double r, const std::string& corners = "0",
              const std::string& before = {}) {
  return run_program(kHead + before + blocks + "M30\n",
                     {.parameters = {{"CCC", corners}}, .radius_of_d1 = r});
}

// The tool centre's way without approach and departure, as short chords.
std::vector<Vec2> way_of(const RunResult& result) {
  const std::vector<motion::Motion> moves = moves_of(result);
  std::vector<Vec2> way;
  for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
    const base::TipPoint& to = *motion::target_of(moves[i]);
    const Vec2 end{to.values[0], to.values[1]};
    if (const auto* const arc = std::get_if<motion::Arc>(&moves[i].action)) {
      const Vec2 centre{arc->center[0], arc->center[1]};
      const bool clockwise = arc->direction == motion::Direction::clockwise;
      const double sweep = geometry::sweep_rad(way.back(), end, centre, clockwise);
      const Vec2 arm = way.back() - centre;
      constexpr int kChords = 40;
      for (int k = 1; k < kChords; ++k) {
        const double angle = (clockwise ? -sweep : sweep) * k / kChords;
        way.push_back(centre + Vec2{arm.u * std::cos(angle) - arm.v * std::sin(angle),
                                    arm.u * std::sin(angle) + arm.v * std::cos(angle)});
      }
    }
    way.push_back(end);
  }
  return way;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length2 = geometry::dot(d, d);
  const double t = length2 == 0 ? 0 : std::clamp(geometry::dot(p - a, d) / length2, 0.0, 1.0);
  return geometry::length(p - (a + t * d));
}

double distance_to_contour(Vec2 p, const Contour& contour) {
  double least = 1e9;
  for (std::size_t i = 0; i < contour.size(); ++i)
    least = std::min(least, distance_to_segment(p, corner(contour, i), corner(contour, i + 1)));
  return least;
}

double distance_to_way(Vec2 p, const std::vector<Vec2>& way) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    least = std::min(least, distance_to_segment(p, way[i], way[i + 1]));
  return least;
}

std::string text(const Contour& contour) {
  std::string result;
  for (const Vec2 point : contour)
    result += " (" + decimal(point.u) + ", " + decimal(point.v) + ")";
  return result;
}

// The first point of a way whose distance from the contour is not from `low` to `high`; empty:
// none.
std::string strays(const std::vector<Vec2>& way, const Contour& contour, double low, double high) {
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    for (int k = 0; k <= 10; ++k) {
      const Vec2 p = way[i] + 0.1 * k * (way[i + 1] - way[i]);
      const double distance = distance_to_contour(p, contour);
      if (distance < low - kTolerance || distance > high + kTolerance) {
        return "(" + std::to_string(p.u) + ", " + std::to_string(p.v) + ") lies " +
               std::to_string(distance) + " from" + text(contour) + ", wanted " +
               std::to_string(low) + " to " + std::to_string(high);
      }
    }
  }
  return {};
}

TEST(CutterCompensation, OutsideOfAConvexContourTheToolIsNeverNearerThanItsRadius) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_convex(random);
    const double r = thousandths(random.in(0.5, 12));
    const RunResult result = run(program_round(contour, "G42"), r);
    ASSERT_EQ(result.alarm, "") << text(contour) << ", radius " << r;
    ASSERT_EQ(strays(way_of(result), contour, r, r * std::numbers::sqrt2), "")
        << "contour " << i << ", seed " << kSeed;
  }
}

TEST(CutterCompensation, BesideTheMiddleOfEveryEdgeTheToolIsAtItsRadius) {
  SeededRandom random(kSeed + 1);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_convex(random);
    const double r = thousandths(random.in(0.5, 12));
    const RunResult result = run(program_round(contour, "G42"), r);
    ASSERT_EQ(result.alarm, "") << text(contour);
    const std::vector<Vec2> way = way_of(result);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Vec2 middle = 0.5 * (corner(contour, k) + corner(contour, k + 1));
      ASSERT_NEAR(distance_to_way(middle, way), r, kTolerance)
          << "edge " << k << " of" << text(contour) << ", contour " << i;
    }
  }
}

TEST(CutterCompensation, WithRoundedCornersSharpOnesAreKeptAtTheRadiusToo) {
  SeededRandom random(kSeed + 2);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_convex(random);
    const double r = thousandths(random.in(0.5, 12));
    const RunResult result = run(program_round(contour, "G42"), r, "1");
    ASSERT_EQ(result.alarm, "") << text(contour);
    for (const motion::Motion& motion : result.motions) {
      const auto* const arc = std::get_if<motion::Arc>(&motion.action);
      if (arc == nullptr) continue;
      const Vec2 end{arc->to.values[0], arc->to.values[1]};
      const Vec2 centre{arc->center[0], arc->center[1]};
      ASSERT_NEAR(geometry::length(end - centre), r, kTolerance) << text(contour);
      ASSERT_NEAR(distance_to_contour(centre, contour), 0, kTolerance) << "an arc about no corner";
    }
    // The chords that stand for arcs lie within them.
    ASSERT_EQ(strays(way_of(result), contour, r * (1 - 1e-3), r * std::numbers::sqrt2), "");
  }
}

TEST(CutterCompensation, NoEdgeOfAStarIsCutInto) {
  SeededRandom random(kSeed + 3);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_star(random);
    const double r = thousandths(random.in(0.2, 1.5));
    for (const bool outside : {true, false}) {
      const RunResult result = run(program_round(contour, outside ? "G42" : "G41"), r);
      ASSERT_EQ(result.alarm, "") << text(contour) << ", radius " << r;
      ASSERT_EQ(strays(way_of(result), contour, r, 1e9), "") << (outside ? "outside" : "inside");
    }
  }
}

TEST(CutterCompensation, TheOtherDirectionOnTheOtherSideIsTheSameCurve) {
  SeededRandom random(kSeed + 4);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = i % 2 == 0 ? random_convex(random) : random_star(random);
    const double r = thousandths(random.in(0.2, 1.5));
    for (const std::string corners : {"0", "1"}) {
      const std::vector<Vec2> one = way_of(run(program_round(contour, "G42"), r, corners));
      std::vector<Vec2> other = way_of(run(program_round(reversed(contour), "G41"), r, corners));
      std::reverse(other.begin(), other.end());
      ASSERT_EQ(one.size(), other.size()) << text(contour) << ", CCC=" << corners;
      for (std::size_t k = 0; k < one.size(); ++k)
        ASSERT_LT(geometry::length(one[k] - other[k]), kTolerance)
            << "point " << k << " of" << text(contour) << ", CCC=" << corners;
    }
  }
}

TEST(CutterCompensation, AMovedContourHasTheMovedPath) {
  SeededRandom random(kSeed + 5);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_star(random);
    const double r = thousandths(random.in(0.2, 1.5));
    const Vec2 shift{thousandths(random.in(-300, 300)), thousandths(random.in(-300, 300))};
    const RunResult here = run(program_round(contour, "G41"), r);
    const RunResult there = run(program_round(contour, "G41", shift), r);
    const RunResult shifted =
        run(program_round(contour, "G41"), r, "0", "G52" + xy(shift.u, shift.v) + "\n");
    ASSERT_EQ(difference(moves_of(there), moves_of(shifted), kTolerance), "") << text(contour);
    const std::vector<Vec2> one = way_of(here);
    const std::vector<Vec2> other = way_of(there);
    ASSERT_EQ(one.size(), other.size()) << text(contour);
    for (std::size_t k = 0; k < one.size(); ++k)
      ASSERT_LT(geometry::length(one[k] + shift - other[k]), kTolerance) << text(contour);
  }
}

TEST(CutterCompensation, ATurnedContourHasTheTurnedPath) {
  SeededRandom random(kSeed + 6);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_star(random);
    const double r = thousandths(random.in(0.2, 1.5));
    const double angle_deg = thousandths(random.in(-180, 180));
    const double angle_rad = angle_deg * kPi / 180;
    const std::vector<Vec2> one = way_of(run(program_round(contour, "G41"), r));
    const std::vector<Vec2> other =
        way_of(run(program_round(contour, "G41"), r, "0", "G68X0Y0R" + decimal(angle_deg) + "\n"));
    ASSERT_EQ(one.size(), other.size()) << text(contour) << ", " << angle_deg << " degrees";
    for (std::size_t k = 0; k < one.size(); ++k) {
      const Vec2 turned{one[k].u * std::cos(angle_rad) - one[k].v * std::sin(angle_rad),
                        one[k].u * std::sin(angle_rad) + one[k].v * std::cos(angle_rad)};
      ASSERT_LT(geometry::length(turned - other[k]), kTolerance)
          << "point " << k << " of" << text(contour) << ", " << angle_deg << " degrees";
    }
  }
}

TEST(CutterCompensation, AMirroredContourHasTheMirroredPath) {
  SeededRandom random(kSeed + 7);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_star(random);
    const double r = thousandths(random.in(0.2, 1.5));
    const std::vector<Vec2> one = way_of(run(program_round(contour, "G41"), r));
    const std::vector<Vec2> other = way_of(run(program_round(contour, "G41"), r, "0", "G51.1X0\n"));
    ASSERT_EQ(one.size(), other.size()) << text(contour);
    for (std::size_t k = 0; k < one.size(); ++k)
      ASSERT_LT(geometry::length(Vec2{-one[k].u, one[k].v} - other[k]), kTolerance)
          << text(contour);
  }
}

TEST(CutterCompensation, ANegativeRadiusIsTheOtherSide) {
  SeededRandom random(kSeed + 8);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_star(random);
    const double r = thousandths(random.in(0.2, 1.5));
    const auto left = moves_of(run(program_round(contour, "G41"), r));
    const auto right = moves_of(run(program_round(contour, "G42"), -r));
    ASSERT_EQ(difference(right, left, kTolerance), "") << text(contour);
  }
}

TEST(CutterCompensation, AnEdgeInTwoPiecesHasTheSamePath) {
  SeededRandom random(kSeed + 9);
  for (int i = 0; i < kContours; ++i) {
    const Contour contour = random_convex(random);
    const double r = thousandths(random.in(0.5, 5));
    // A point that lies on its edge only to a thousandth: the path may follow it that far.
    Contour split;
    for (std::size_t k = 0; k < contour.size(); ++k) {
      if (k > 0) split.push_back(middle_of(contour[k - 1], contour[k]));
      split.push_back(contour[k]);
    }
    const std::vector<Vec2> one = way_of(run(program_round(contour, "G42"), r));
    const std::vector<Vec2> other = way_of(run(program_round(split, "G42"), r));
    ASSERT_FALSE(other.empty());
    for (const Vec2 p : one) ASSERT_LT(distance_to_way(p, other), 5e-3) << text(contour);
    for (const Vec2 p : other) ASSERT_LT(distance_to_way(p, one), 5e-3) << text(contour);
  }
}

// A rectangle with round corners: tangents everywhere.
std::string round_rectangle(double half_width, double half_height, double corner_radius,
                            bool clockwise) {
  const double w = half_width;
  const double h = half_height;
  const double c = corner_radius;
  const std::string r = "R" + decimal(c) + "\n";
  if (clockwise) {
    return "G01" + xy(0, h) + "\n" + xy(w - c, h) + "\nG02" + xy(w, h - c) + r + "G01" +
           xy(w, c - h) + "\nG02" + xy(w - c, -h) + r + "G01" + xy(c - w, -h) + "\nG02" +
           xy(-w, c - h) + r + "G01" + xy(-w, h - c) + "\nG02" + xy(c - w, h) + r + "G01" +
           xy(0, h) + "\n";
  }
  return "G01" + xy(0, h) + "\n" + xy(c - w, h) + "\nG03" + xy(-w, h - c) + r + "G01" +
         xy(-w, c - h) + "\nG03" + xy(c - w, -h) + r + "G01" + xy(w - c, -h) + "\nG03" +
         xy(w, c - h) + r + "G01" + xy(w, h - c) + "\nG03" + xy(w - c, h) + r + "G01" + xy(0, h) +
         "\n";
}

TEST(CutterCompensation, AlongLinesAndArcsThatMeetSmoothlyTheToolIsAtItsRadiusEverywhere) {
  SeededRandom random(kSeed + 10);
  for (int i = 0; i < kContours; ++i) {
    const double w = thousandths(random.in(30, 80));
    const double h = thousandths(random.in(30, 80));
    const double c = thousandths(random.in(8, 25));
    const bool clockwise = random.count(0, 1) == 1;
    const bool inside = random.count(0, 1) == 1;
    const double r = thousandths(random.in(0.5, 0.9 * c));
    const std::string side = clockwise == inside ? "G42" : "G41";
    const double start = inside ? h / 3 : h + 30;
    const std::string lead = xy(0, start) + "\n";
    const std::string contour = round_rectangle(w, h, c, clockwise);
    const RunResult result = run("G00" + lead + side + "D1" + contour + "G40" + lead, r);
    ASSERT_EQ(result.alarm, "") << contour;
    const double outer_r = inside ? c - r : c + r;
    for (const Vec2 p : way_of(result)) {
      // Distance from the middle part of the rectangle, whose offset by c is the contour.
      const double du = std::max(std::fabs(p.u) - (w - c), 0.0);
      const double dv = std::max(std::fabs(p.v) - (h - c), 0.0);
      ASSERT_NEAR(std::hypot(du, dv), outer_r, kTolerance)
          << (inside ? "inside, radius " : "outside, radius ") << r << ", contour " << i << "\n"
          << contour;
    }
  }
}

TEST(CutterCompensation, AnInsideRadiusSmallerThanTheToolsIsAnAlarm) {
  SeededRandom random(kSeed + 11);
  for (int i = 0; i < 50; ++i) {
    const double c = thousandths(random.in(1, 5));
    const double r = thousandths(c * random.in(1.01, 3));
    const std::string blocks =
        "G00X0Y10.\nG42D1" + round_rectangle(40, 40, c, true) + "G40X0Y10.\n";
    const RunResult result = run(blocks, r);
    ASSERT_EQ(result.alarm.substr(0, 6), "PS0041") << "corner " << c << ", radius " << r;
  }
}

}  // namespace
}  // namespace kerf::test
