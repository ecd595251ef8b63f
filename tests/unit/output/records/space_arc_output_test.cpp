// What watches the motions does with arcs in space, which no program commands yet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <numbers>
#include <sstream>
#include <vector>

#include "base/output_file.hpp"
#include "machine/run/run_statistics.hpp"
#include "motion/space_arc_path.hpp"
#include "output/programs/post.hpp"
#include "output/records/motion_json.hpp"
#include "output/records/row_csv.hpp"
#include "space_arc_cases.hpp"
#include "temporary_folder.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using base::TipPoint;
using motion::Motion;

const motion::AxisSetup kAxes = five_axes();
constexpr double kFeed_mm_min = 3000;
constexpr double kFeed_mm_s = 50;

std::string written(const std::function<void(base::OutputFile&)>& write) {
  const TemporaryFolder folder;
  auto file = base::OutputFile::create(folder / "out");
  write(**file);
  EXPECT_TRUE((*file)->commit());
  return folder.read("out");
}

// To where the arc starts, then the arc.
template <typename Sink>
void make(Sink& sink, const SpaceArcCase& arc, const motion::SpaceArc& action) {
  sink.take(motion_of(motion::Rapid{arc.from}));
  sink.take(motion_of(action));
}

std::string json_of(const SpaceArcCase& arc, const motion::SpaceArc& action) {
  const std::string text = written([&](base::OutputFile& file) {
    output::MotionJson json(kAxes, nullptr, file);
    make(json, arc, action);
  });
  return text.substr(text.find('\n') + 1);
}

TEST(SpaceArcInMotionJson, HasItsCircle) {
  EXPECT_EQ(json_of(kSpaceArcs[0], kSpaceArcs[0].arc(kFeed_mm_min)),
            "{\"kind\":\"space-arc\",\"program\":\"O0000\",\"line\":0,"
            "\"to\":{\"X\":-40,\"Y\":0,\"Z\":0,\"A\":30,\"C\":90},"
            "\"via\":{\"X\":0,\"Y\":40,\"Z\":0,\"A\":10,\"C\":45},"
            "\"center\":[0,0,0],\"normal\":[0,0,1],\"sweep_deg\":180,"
            "\"feed\":3000,\"feed_mode\":\"per-minute\"}\n");
}

TEST(SpaceArcInMotionJson, OfAFullCircleHasBothPoints) {
  EXPECT_EQ(json_of(kSpaceArcs[3], kSpaceArcs[3].circle(kFeed_mm_min)),
            "{\"kind\":\"space-arc\",\"program\":\"O0000\",\"line\":0,"
            "\"to\":{\"X\":0,\"Y\":0,\"Z\":0,\"A\":0,\"C\":0},"
            "\"via\":{\"X\":30,\"Y\":0,\"Z\":40,\"A\":20,\"C\":-10},"
            "\"second_via\":{\"X\":60,\"Y\":0,\"Z\":0,\"A\":5,\"C\":-40},"
            "\"center\":[30,0,8.75],\"normal\":[0,1,0],\"sweep_deg\":360,"
            "\"feed\":3000,\"feed_mode\":\"per-minute\"}\n");
}

const machine::MachineDefinition& five_axis_machine() {
  static const machine::MachineDefinition machine = [] {
    machine::MachineDefinition made;
    made.axes = kAxes;
    return made;
  }();
  return machine;
}

// The tips of the G1 blocks, and how many of them have an F.
struct Posted {
  std::vector<TipPoint> tips;
  int feeds = 0;
};

void read_word(const std::string& word, TipPoint& at, Posted& posted) {
  if (word[0] == 'F') ++posted.feeds;
  if (const auto axis = kAxes.find(word[0])) at[*axis] = std::stod(word.substr(1));
}

Posted posted(const SpaceArcCase& arc, const motion::SpaceArc& action) {
  std::istringstream lines(written([&](base::OutputFile& file) {
    output::Post post(five_axis_machine(), "part", file);
    make(post, arc, action);
    post.finish();
  }));
  Posted result;
  TipPoint at;
  bool cutting = false;
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == '(' || line[0] == 'M' || line.starts_with("G21")) continue;
    cutting |= line.starts_with("G1");
    std::istringstream words(line);
    for (std::string word; words >> word;) read_word(word, at, result);
    if (cutting) result.tips.push_back(at);
  }
  return result;
}

TipPoint halfway(const TipPoint& a, const TipPoint& b) {
  TipPoint middle;
  for (std::size_t i = 0; i < base::kMaxAxes; ++i)
    middle.values[i] = (a.values[i] + b.values[i]) / 2;
  return middle;
}

constexpr double kRounding_mm = 1e-4;

TEST(SpaceArcInPlainGCode, IsChordsWithinTheTolerance) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    const Posted lines = posted(arc, arc.arc(kFeed_mm_min));
    TipPoint before = arc.from;
    for (const TipPoint& tip : lines.tips) {
      EXPECT_LE(arc.distance_mm(tip), kRounding_mm) << arc.name;
      EXPECT_LE(arc.distance_mm(halfway(before, tip)),
                output::Post::kChordTolerance_mm + kRounding_mm)
          << arc.name;
      before = tip;
    }
    EXPECT_EQ(lines.tips.back(), arc.to) << arc.name;
    EXPECT_EQ(lines.feeds, 1) << arc.name;
    EXPECT_NE(std::find(lines.tips.begin(), lines.tips.end(), arc.via), lines.tips.end());
  }
}

TEST(SpaceArcInRows, IsTheChordsOfThePlainGCode) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    const control::Memory memory(1);
    std::istringstream lines(written([&](base::OutputFile& file) {
      output::RowCsv rows(kAxes, memory, file);
      make(rows, arc, arc.arc(kFeed_mm_min));
    }));
    std::string line;
    std::getline(lines, line);  // the header
    std::getline(lines, line);  // to where it starts
    for (const TipPoint& tip : posted(arc, arc.arc(kFeed_mm_min)).tips) {
      ASSERT_TRUE(std::getline(lines, line)) << arc.name;
      double x = 0;
      double y = 0;
      double z = 0;
      ASSERT_EQ(std::sscanf(line.c_str(), "0,1,%lf,%lf,%lf,0,0,0,0,0,3000,", &x, &y, &z), 3)
          << line;
      EXPECT_NEAR(x, tip.values[0], kRounding_mm) << arc.name;
      EXPECT_NEAR(y, tip.values[1], kRounding_mm) << arc.name;
      EXPECT_NEAR(z, tip.values[2], kRounding_mm) << arc.name;
    }
    EXPECT_FALSE(std::getline(lines, line)) << arc.name << ": " << line;
  }
}

TEST(SpaceArcInPlainGCode, HasNoMoreChordsThanItNeeds) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    const double chord_deg =
        2 * std::acos(1 - output::Post::kChordTolerance_mm / arc.radius) * 180 / std::numbers::pi;
    EXPECT_LE(posted(arc, arc.arc(kFeed_mm_min)).tips.size(), arc.sweep_deg / chord_deg + 2);
  }
}

TEST(SpaceArcInPlainGCode, AFullCircleComesBack) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    const Posted lines = posted(arc, arc.circle(kFeed_mm_min));
    EXPECT_EQ(lines.tips.back(), arc.from) << arc.name;
    EXPECT_NE(std::find(lines.tips.begin(), lines.tips.end(), arc.to), lines.tips.end());
  }
}

TEST(SpaceArcInStatistics, HasLengthAndTime) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    machine::RunStatistics statistics(kAxes);
    make(statistics, arc, arc.arc(kFeed_mm_min));
    const double before_s = statistics.feed_seconds();
    const double length = arc.radius * arc.sweep_deg * std::numbers::pi / 180;
    EXPECT_NEAR(statistics.cut_mm(), length, 1e-5) << arc.name;
    EXPECT_EQ(statistics.motions(), 2U);
    EXPECT_EQ(statistics.at(), arc.to) << arc.name;
    statistics.take(motion_of(motion::Rapid{arc.from}));
    const double rapid_s = statistics.feed_seconds() - before_s;
    statistics.take(motion_of(arc.circle(kFeed_mm_min)));
    EXPECT_NEAR(statistics.feed_seconds() - before_s - rapid_s,
                2 * std::numbers::pi * arc.radius / kFeed_mm_s, 1e-6)
        << arc.name;
  }
}

// Against the extremes of a hundred thousand points.
void expect_extents(const SpaceArcCase& arc, const motion::SpaceArc& action) {
  constexpr int kPoints = 100'000;
  const motion::SpaceArcPath path(kAxes, arc.from, action);
  machine::RunStatistics statistics(kAxes);
  make(statistics, arc, action);
  TipPoint low = arc.from, high = arc.from;
  for (int k = 0; k <= kPoints; ++k) {
    const TipPoint tip = path.at(path.circle().sweep_rad() * k / kPoints);
    for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
      low.values[i] = std::min(low.values[i], tip.values[i]);
      high.values[i] = std::max(high.values[i], tip.values[i]);
    }
  }
  const double fineness = 1e-3;  // a rotary axis may turn round between two points
  for (std::size_t i = 0; i < 5; ++i) {
    const double tolerance = i < 3 ? 1e-6 : fineness;
    EXPECT_NEAR(statistics.low().values[i], low.values[i], tolerance) << arc.name << ", axis " << i;
    EXPECT_NEAR(statistics.high().values[i], high.values[i], tolerance)
        << arc.name << ", axis " << i;
  }
}

TEST(SpaceArcInStatistics, ExtentsIncludeItsBulges) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    expect_extents(arc, arc.arc(kFeed_mm_min));
    expect_extents(arc, arc.circle(kFeed_mm_min));
  }
}

TEST(SpaceArcInStatistics, WhereTheRunBeginsDoesNotCount) {
  machine::RunStatistics statistics(kAxes);
  statistics.take(motion_of(kSpaceArcs[3].arc(kFeed_mm_min)));
  EXPECT_EQ(statistics.low().values[4], -40);
  EXPECT_EQ(statistics.high().values[4], -10);  // C 0 at the start
  EXPECT_NEAR(statistics.low().values[0], 30 - 31.25, 1e-12);
  EXPECT_NEAR(statistics.high().values[0], 30 + 31.25, 1e-12);
}

}  // namespace
}  // namespace kerf::test
