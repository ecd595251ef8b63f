#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "output/picture/drawing/palette.hpp"
#include "output/picture/internal/cut_recorder.hpp"
#include "output/picture/internal/cut_tracer.hpp"
#include "output/picture/internal/subject.hpp"
#include "output/picture/path_plot.hpp"
#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

using namespace testing;

constexpr double kFeed = 6000;  // mm/min
constexpr double kTop = kFeed / 60;
constexpr double kRamp = 500;  // mm/s²
constexpr double kPeriod_s = 0.001;
constexpr double kRampLength = kTop * kTop / (2 * kRamp);  // 10 mm

// mm/s at a place on a line of this length that begins and ends at rest: the formula.
double speed_on_line(double at, double length) {
  return std::min(kTop, std::sqrt(2 * kRamp * std::max(0.0, std::min(at, length - at))));
}

// Where a line from rest to rest is after this time; longer than two ramps.
double place_on_line(double time_s, double length) {
  const double ramp_s = kTop / kRamp;
  const double total_s = ramp_s + length / kTop;
  if (time_s < ramp_s) return kRamp * time_s * time_s / 2;
  if (time_s < total_s - ramp_s) return kRampLength + kTop * (time_s - ramp_s);
  const double left_s = std::max(0.0, total_s - time_s);
  return length - kRamp * left_s * left_s / 2;
}

/// Makes set-points: a servo whose tip follows functions of time.
template <typename Take>
class Machine {
 public:
  explicit Machine(Take take) : take_(take) {}

  template <typename Way>
  void move(double seconds, Way way, motion::MoveKind kind = motion::MoveKind::cut) {
    const auto periods = static_cast<int>(std::ceil(seconds / kPeriod_s - 1e-9));
    for (int i = 1; i <= periods; ++i) {
      motion::Setpoint point;
      point.tip = way(std::min(i * kPeriod_s, seconds));
      point.time_s = static_cast<double>(++count_) * kPeriod_s;
      point.mark.kind = kind;
      point.mark.power_percent = power_percent;
      take_(point);
    }
  }

  /// From rest to rest.
  void line(const Point3& from, const Point3& to, motion::MoveKind kind = motion::MoveKind::cut) {
    const Point3 way = to - from;
    const double length = std::hypot(way[kX], way[kY], way[kZ]);
    move(
        kTop / kRamp + length / kTop,
        [&](double time_s) {
          const double part = place_on_line(time_s, length) / length;
          return at(from[kX] + way[kX] * part, from[kY] + way[kY] * part,
                    from[kZ] + way[kZ] * part);
        },
        kind);
  }

  float power_percent = 0;

 private:
  Take take_;
  std::uint64_t count_ = 0;
};

// A recording of a machine that moves in XY, and how it is drawn.
struct Drawing {
  Drawing() { speeds.start({}); }

  auto machine() {
    return Machine([this](const motion::Setpoint& point) {
      speeds.take(point, 0);
      if (point.mark.kind == motion::MoveKind::cut)
        motions.take(motion(motion::Line{point.tip, {}}));
    });
  }

  // The shades of all lines through a place, from the slowest.
  std::vector<std::size_t> shades_at(double x, double y) const {
    const Subject subject(motions, &speeds);
    const Rect frame{0, 0, 1000, 1000};
    const View view(kFromAbove, subject.box, frame, frame);
    CutTracer tracer(view, subject.values, *subject.cut_scale);
    std::vector<std::size_t> found;
    for (std::size_t shade = 0; shade < CutScale::kShades; ++shade) {
      if (passes(tracer.lines()[shade], view.map({x, y, 0}))) found.push_back(shade);
    }
    return found;
  }

  // kShades where nothing is drawn.
  std::size_t slowest_at(double x, double y) const {
    const auto found = shades_at(x, y);
    return found.empty() ? CutScale::kShades : found.front();
  }

  std::size_t dot_count() const {
    const Subject subject(motions, &speeds);
    const Rect frame{0, 0, 1000, 1000};
    const View view(kFromAbove, subject.box, frame, frame);
    CutTracer tracer(view, subject.values, *subject.cut_scale);
    std::size_t count = 0;
    for (const Outline& dots : tracer.dots()) count += dots.points.size() / 2;
    return count;
  }

  static bool passes(const Outline& outline, Point p) {
    constexpr double kNear = 0.5;  // pixels
    for (std::size_t i = 1; i < outline.steps.size(); ++i) {
      const Point a = outline.points[i - 1], b = outline.points[i];
      const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
      if (outline.steps[i] == Outline::Step::move) continue;
      const double t = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
      const double s = std::clamp(t, 0.0, 1.0);
      if (std::hypot(a.x + s * dx - p.x, a.y + s * dy - p.y) < kNear) return true;
    }
    return false;
  }

  // Precondition: nothing else is drawn there.
  void expect_shade(double x, double y, double speed_mm_s) const {
    const double wanted = speed_mm_s / kTop * CutScale::kShades;
    EXPECT_NEAR(static_cast<double>(slowest_at(x, y)) + 0.5, wanted, 1) << "at " << x << ", " << y;
  }

  PathRecorder motions{axes("XYZ")};
  CutRecorder speeds{axes("XYZ"), std::make_unique<SpeedOfCut>()};
};

TEST(SpeedPlot, ALineShowsTheRampsAtItsEnds) {
  Drawing drawing;
  drawing.machine().line({0, 0, 0}, {100, 0, 0});
  EXPECT_NEAR(drawing.speeds.measure().scale().top(), kFeed, 1e-6);
  EXPECT_EQ(drawing.slowest_at(0, 0), 0U);
  EXPECT_EQ(drawing.shades_at(50, 0), std::vector<std::size_t>{CutScale::kShades - 1});
  EXPECT_EQ(drawing.slowest_at(100, 0), 0U);
  for (const double x : {0.5, 1.0, 2.0, 4.0, 6.0, 8.0, 12.0, 88.0, 94.0, 97.0, 99.0}) {
    drawing.expect_shade(x, 0, speed_on_line(x, 100));
  }
}

TEST(SpeedPlot, AnArcHasTheSpeedAlongIt) {
  Drawing drawing;
  auto machine = drawing.machine();
  const double radius = 30, length = radius * std::numbers::pi;
  drawing.speeds.start({0, at(radius, 0), {}});
  machine.move(kTop / kRamp + length / kTop, [&](double time_s) {
    const double angle_rad = place_on_line(time_s, length) / radius;
    return at(radius * std::cos(angle_rad), radius * std::sin(angle_rad));
  });
  for (const double way : {1.0, 3.0, 7.0, 40.0, 90.0, 93.0}) {
    const double angle_rad = way / radius;
    drawing.expect_shade(radius * std::cos(angle_rad), radius * std::sin(angle_rad),
                         speed_on_line(way, length));
  }
}

TEST(SpeedPlot, ACornerTooShortToSeeIsADot) {
  Drawing drawing;
  auto machine = drawing.machine();
  const auto along = [](double speed) {
    return [speed](double time_s) { return at(speed * time_s, 0); };
  };
  machine.move(0.5, along(kTop));  // without ramps, but for two periods
  machine.move(0.002, [](double time_s) { return at(kTop / 2 + 5 * time_s, 0); });
  machine.move(0.5, [](double time_s) { return at(kTop / 2 + 0.01 + kTop * time_s, 0); });
  EXPECT_EQ(drawing.dot_count(), 3U);  // and both ends
  EXPECT_LE(drawing.slowest_at(50, 0), 1U);
}

TEST(SpeedPlot, RapidsAndDwellsAreNotShaded) {
  Drawing drawing;
  auto machine = drawing.machine();
  machine.line({0, 0, 0}, {100, 0, 0});
  machine.line({100, 0, 0}, {100, 100, 0}, motion::MoveKind::rapid);
  machine.move(
      0.1, [](double) { return at(100, 100); }, motion::MoveKind::dwell);
  machine.line({100, 100, 0}, {0, 100, 0});
  EXPECT_TRUE(drawing.shades_at(100, 50).empty());
  EXPECT_FALSE(drawing.shades_at(50, 100).empty());
  EXPECT_EQ(drawing.speeds.path().strokes.size(), 2U);
}

TEST(SpeedPlot, ABeamThatIsOffTravels) {
  Drawing drawing;
  auto machine = drawing.machine();
  machine.power_percent = 50;
  machine.line({0, 0, 0}, {100, 0, 0});
  machine.power_percent = 0;
  machine.line({100, 0, 0}, {100, 100, 0});
  EXPECT_FALSE(drawing.shades_at(50, 0).empty());
  EXPECT_TRUE(drawing.shades_at(100, 50).empty());
}

TEST(SpeedPlot, WhatGoesOnElsewhereIsNotJoined) {
  Drawing drawing;
  auto machine = drawing.machine();
  machine.line({0, 0, 0}, {100, 0, 0});
  drawing.speeds.start({1.5, at(100, 100), {}});
  machine.line({100, 100, 0}, {0, 100, 0});
  EXPECT_TRUE(drawing.shades_at(100, 50).empty());
}

// Twenty minutes of a zigzag: more than a million set-points.
TEST(SpeedPlot, ALongRunKeepsItsRampsInBoundedMemory) {
  Drawing drawing;
  auto machine = drawing.machine();
  for (int row = 0; row < 1000; ++row) {
    const double y = 0.1 * row, from = row % 2 == 0 ? 0 : 100;
    machine.line({from, y, 0}, {100 - from, y, 0});
  }
  EXPECT_GT(drawing.speeds.tolerance(), 0);
  EXPECT_LE(drawing.speeds.path().vertices.size(), PathStore::kBudget + 1);
  for (const double x : {0.0, 0.5, 2.0, 6.0, 50.0, 95.0, 98.0}) {
    drawing.expect_shade(x, 50, speed_on_line(x, 100));
  }
}

// How bright a colour is in grey: ITU-R BT.709.
double brightness(Color color) {
  const auto linear = [](std::uint8_t part) { return std::pow(part / 255.0, 2.2); };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

TEST(CutScale, ColoursKeepTheirOrderInGreyAndShowOnWhite) {
  const CutScale scale = CutScale::of_speeds(1000);
  for (std::size_t shade = 1; shade < CutScale::kShades; ++shade) {
    EXPECT_GT(brightness(scale.color(shade)), brightness(scale.color(shade - 1)));
  }
  EXPECT_LT(brightness(scale.color(CutScale::kShades - 1)), 0.6);
}

TEST(CutScale, ShadesAreEqualStepsFromZeroToTheFastest) {
  const CutScale scale = CutScale::of_speeds(2400);
  EXPECT_EQ(scale.shade(0), 0U);
  EXPECT_EQ(scale.shade(99), 0U);
  EXPECT_EQ(scale.shade(101), 1U);
  EXPECT_EQ(scale.shade(2399), CutScale::kShades - 1);
  EXPECT_EQ(scale.shade(2400), CutScale::kShades - 1);
  EXPECT_EQ(scale.shade(9999), CutScale::kShades - 1);
  EXPECT_EQ(CutScale::of_speeds(0).shade(0), 0U);
}

// A whole picture of what a machine does.
class Sheet {
 public:
  void line(const Point3& from, const Point3& to) {
    plot.take(motion(motion::Line{at(to[kX], to[kY], to[kZ]), {}}));
    machine_.line(from, to);
  }
  void rapid(const Point3& from, const Point3& to) {
    plot.take(motion(motion::Rapid{at(to[kX], to[kY], to[kZ])}));
    machine_.line(from, to, motion::MoveKind::rapid);
  }

  PathPlot plot{axes("XYZ"), "speeds", PlotColors::speeds};

 private:
  struct Forward {
    PathPlot& plot;
    void operator()(const motion::Setpoint& point) const {
      plot.take(motion::AxisPoint{point, base::JointPoint(point.tip.numbers())});
    }
  };
  Machine<Forward> machine_{Forward{plot}};
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t from = text.find(part); from != std::string::npos;
       from = text.find(part, from + 1)) {
    ++found;
  }
  return found;
}

TEST(SpeedPlot, TheLegendHasRoundNumbersFromZeroToTheFastestCut) {
  Sheet sheet;
  sheet.rapid({0, 0, 0}, {0, 50, 0});
  sheet.line({0, 50, 0}, {500, 50, 0});
  const std::string svg = sheet.plot.svg();
  const std::size_t legend = svg.find("mm/min<");
  ASSERT_NE(legend, std::string::npos);
  for (const char* number : {">0<", ">1000<", ">2000<", ">5000<", ">6000<"}) {
    EXPECT_NE(svg.find(number, legend), std::string::npos) << number;
  }
  EXPECT_EQ(svg.find(">7000<", legend), std::string::npos);
  EXPECT_NE(svg.find(">fastest cut 6000 ", legend), std::string::npos);
  EXPECT_EQ(svg.find(">Tools<"), std::string::npos);
  EXPECT_EQ(count(svg, "stroke-dasharray"), 3U);    // the rapid in two views, and the legend
  EXPECT_GE(count(svg, "stroke=\"#440154\""), 2U);  // standing still
  EXPECT_EQ(count(svg, "stroke=\"#7ad151\""), 2U);  // as fast as it gets, in two views
  EXPECT_EQ(count(svg, "fill=\"#7ad151\""), 1U);    // and in the legend
}

TEST(SpeedPlot, WithoutCutsThereIsNoScale) {
  Sheet sheet;
  sheet.rapid({0, 0, 0}, {0, 50, 0});
  EXPECT_NE(sheet.plot.svg().find("nothing is cut"), std::string::npos);
  EXPECT_TRUE(sheet.plot.png().starts_with("\x89PNG\r\n"));
}

TEST(SpeedPlot, ATangleOfRampsGivesAPictureOfBoundedSize) {
  Sheet sheet;
  Random random(3);
  Point3 here{};
  for (int i = 0; i < 3000; ++i) {  // each at least two ramps long
    const Point3 next{here[kX] > 50 ? 30 * random.next() : 70 + 30 * random.next(),
                      100 * random.next(), 0};
    sheet.line(here, next);
    here = next;
  }
  EXPECT_LT(sheet.plot.svg().size(), 2'100'000U);
}

TEST(SpeedPlot, ALatheIsDrawnInItsPlane) {
  PathPlot plot(lathe_axes(), "lathe", PlotColors::speeds);
  plot.start({});
  Machine machine([&](const motion::Setpoint& point) {
    plot.take(motion::AxisPoint{point, base::JointPoint(point.tip.numbers())});
    plot.take(motion(motion::Line{point.tip, {}}));
  });
  machine.move(1, [](double time_s) { return at(20 * time_s, -15 * time_s); });  // 25 mm/s
  const std::string svg = plot.svg();
  EXPECT_NE(svg.find(">X \u2300 mm<"), std::string::npos);
  EXPECT_NE(svg.find(">fastest cut 1500 "), std::string::npos);
  EXPECT_GE(count(svg, "stroke=\"#7ad151\""), 1U);
}

TEST(SpeedPlot, TheSameRunGivesTheSameBytes) {
  Sheet first, second;
  for (Sheet* sheet : {&first, &second}) {
    for (int row = 0; row < 200; ++row) sheet->line({0, 0.5 * row, 0}, {100, 0.5 * row, 0});
  }
  EXPECT_EQ(first.plot.svg(), second.plot.svg());
  EXPECT_EQ(first.plot.svg(), first.plot.svg());
  EXPECT_EQ(first.plot.png(), second.plot.png());
}

}  // namespace
}  // namespace kerf::output::plot
