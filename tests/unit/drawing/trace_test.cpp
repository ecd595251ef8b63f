#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "drawing/cubic_spline.hpp"
#include "drawing/trace/lens_shape.hpp"
#include "drawing/trace/trace_reader.hpp"
#include "drawn.hpp"

namespace kerf::drawing {
namespace {

constexpr double kPi = std::numbers::pi;

std::string trace(int count, const std::string& side, const std::function<double(double)>& radius) {
  std::string text = "TRCFMT=1;" + std::to_string(count) + ";E;" + side + ";F\r\n";
  for (int i = 0; i < count; ++i) {
    text += i % 10 == 0 ? "R=" : ";";
    text += std::to_string(100 * radius(2 * kPi * i / count));
    if (i % 10 == 9 || i + 1 == count) text += "\r\n";
  }
  return text;
}

double ellipse_radius(double angle) {
  return 25 * 20 / std::hypot(20 * std::cos(angle), 25 * std::sin(angle));
}

Drawn read(const std::string& text, Reading how = {}) { return Drawn(read_trace, text, how); }

TEST(Trace, equal_radii_are_a_circle) {
  const Drawn drawn = read(trace(36, "R", [](double) { return 25.0; }));
  EXPECT_EQ(drawn.findings(), "");
  const contour::Contour path = drawn.path(0);
  EXPECT_TRUE(path.is_closed);
  EXPECT_EQ(path.vertices.size(), 2U);
  EXPECT_NEAR(length(path), 50 * kPi, 1e-9);
}

TEST(Trace, radii_of_an_ellipse_are_that_ellipse) {
  const contour::Contour path = read(trace(400, "R", ellipse_radius)).path(0);
  EXPECT_NEAR(length(path), 141.808339299, 0.02);
  EXPECT_NEAR(area(path), 500 * kPi, 0.2);
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * kPi * i / 1000;
    const double radius = ellipse_radius(angle);
    EXPECT_LE(distance(path, {radius * std::cos(angle), radius * std::sin(angle)}), 0.0101);
  }
}

TEST(Trace, it_goes_counterclockwise_from_x_through_all_radii_within_the_tolerance) {
  const auto radius = [](double angle) {
    return 20 + 3 * std::sin(3 * angle) + std::cos(7 * angle);
  };
  const contour::Contour path = read(trace(60, "B", radius)).path(0);
  EXPECT_GT(area(path), 0);
  for (int i = 0; i < 60; ++i) {
    const double angle = 2 * kPi * i / 60;
    EXPECT_LE(distance(path, {radius(angle) * std::cos(angle), radius(angle) * std::sin(angle)}),
              0.0101);
  }
}

TEST(Trace, unequal_angles_are_where_they_say) {
  const Drawn drawn = read("TRCFMT=1;4;U;R;F\nR=1000;2000;1000;2000\nA=0;10000;18000;28000\n");
  EXPECT_EQ(drawn.findings(), "");
  const double angle = 100 * kPi / 180;
  EXPECT_LE(distance(drawn.path(0), {20 * std::cos(angle), 20 * std::sin(angle)}), 0.01);
}

TEST(Trace, the_other_side_is_mirrored) {
  const auto radius = [](double angle) { return 20 + 2 * std::cos(angle) + std::sin(2 * angle); };
  Reading left;
  left.lens_side = 'L';
  const contour::Contour as_is = read(trace(90, "R", radius)).path(0);
  const contour::Contour other = read(trace(90, "R", radius), left).path(0);
  EXPECT_NEAR(extents(other).low.u, -extents(as_is).high.u, 1e-6);
  EXPECT_NEAR(extents(other).high.u, -extents(as_is).low.u, 1e-6);
  EXPECT_NEAR(extents(other).high.v, extents(as_is).high.v, 1e-6);
  EXPECT_NEAR(area(other), area(as_is), 1e-3);
  const contour::Contour same = read(trace(90, "L", radius), left).path(0);
  EXPECT_EQ(extents(same).high.u, extents(as_is).high.u);
}

TEST(Trace, of_two_sides_one_is_drawn) {
  const std::string both =
      trace(9, "R", [](double) { return 10.0; }) + trace(9, "L", [](double) { return 30.0; });
  Reading left;
  left.lens_side = 'L';
  EXPECT_NEAR(length(read(both).path(0)), 20 * kPi, 1e-9);
  EXPECT_NEAR(length(read(both, left).path(0)), 60 * kPi, 1e-9);
  EXPECT_EQ(read(both).ignored(), "another trace 1");
}

TEST(Trace, boxes_that_differ_are_told) {
  const std::string lens = trace(36, "L", [](double) { return 25.0; });
  EXPECT_EQ(read(lens + "HBOX=44;50.19\nVBOX=49.9\n").codes(), "");
  EXPECT_EQ(read(lens + "HBOX=50;50.3\n").findings(),
            "TRACE_BOX:6 the lens is not as large as its box: HBOX says 50.3 mm, and the curve has "
            "50\n");
}

TEST(Trace, what_is_wrong_is_told) {
  EXPECT_EQ(read("JOB=1\n").codes(), "TRACE_FORMAT");
  EXPECT_EQ(read("TRCFMT=4;3;E;R;F\nR=1;2;3\n").codes(), "TRACE_FORMAT");
  EXPECT_EQ(read("TRCFMT=1;4;E;R;F\nR=1;2;3\n").codes(), "TRACE_COUNT");
  EXPECT_EQ(read("TRCFMT=1;2;E;R;F\nR=1;2\n").codes(), "TRACE_COUNT");
  EXPECT_EQ(read("TRCFMT=1;10001;E;R;F\nR=1;2\n").codes(), "TRACE_COUNT");
  EXPECT_EQ(read("TRCFMT=1;3;E;R;F\nR=1;2;x\n").codes(), "TRACE_COUNT");
  EXPECT_EQ(read("TRCFMT=1;3;E;R;F\nR=1;0;3\n").codes(), "TRACE_COUNT");
  EXPECT_EQ(read("TRCFMT=1;3;U;R;F\nR=1;2;3\nA=0;20000;10000\n").codes(), "TRACE_COUNT");
  EXPECT_EQ(read("TRCFMT=1;3;U;R;F\nR=1;2;3\n").codes(), "TRACE_COUNT");
}

TEST(Trace, control_bytes_and_bevels) {
  const Drawn drawn = read(
      "\x1c"
      "trcfmt=1;3;E;R;F\r\nR=1000;1000;1000;\r\nBEVP=1\r\nBEVM=0\r\nDRILLE=R;1.5\r\n\x1d");
  EXPECT_EQ(drawn.codes(), "");
  EXPECT_EQ(drawn.ignored(), "bevel 1, holes 1");
}

contour::Contour lens(const char* word) {
  Drawing drawing;
  const Reading reading;
  Canvas canvas(reading, drawing);
  draw_lens_shape(*read_lens_shape(word), base::FileId{0}, canvas);
  return contour_of(drawing, drawing.paths.at(0));
}

TEST(LensShape, has_its_measures) {
  EXPECT_NEAR(length(lens("lens:round:50")), 50 * kPi, 1e-9);
  EXPECT_NEAR(length(lens("lens:oval:50,40")), 141.808339299, 0.02);
  EXPECT_NEAR(area(lens("lens:oval:50,40")), 1570.796326795, 0.1);
  EXPECT_NEAR(area(lens("lens:box:50,40,5")), 2000 - (100 - 25 * kPi), 1e-9);
  EXPECT_EQ(lens("lens:box:50,40,0").vertices.size(), 4U);
  EXPECT_NEAR(length(lens("lens:box:40,40,20")), 40 * kPi, 1e-9);
}

TEST(LensShape, is_refused_with_a_sentence) {
  for (const char* word :
       {"lens:", "lens:star:4", "lens:round:", "lens:round:-1", "lens:round:1,2", "lens:oval:5",
        "lens:box:9,8,5", "lens:box:9,8,x", "lens:oval:5,99999"}) {
    const auto shape = read_lens_shape(word);
    ASSERT_FALSE(shape) << word;
    EXPECT_EQ(shape.error().kind, base::Failure::Kind::usage);
  }
}

TEST(CubicSpline, takes_cubics_as_they_are) {
  const std::vector<double> at{0, 1, 1.5, 4};
  std::vector<double> values;
  for (const double t : at) values.push_back(t * t * t - 2 * t * t + 5);
  const std::vector<double> slopes = spline_slopes(at, values, 0, 3 * 16 - 16);
  for (std::size_t i = 0; i < at.size(); ++i)
    EXPECT_NEAR(slopes[i], 3 * at[i] * at[i] - 4 * at[i], 1e-12);
}

TEST(CubicSpline, without_slopes_its_ends_are_straight) {
  const std::vector<double> slopes =
      spline_slopes(std::vector<double>{0, 2, 3}, std::vector<double>{1, 5, 7});
  for (const double slope : slopes) EXPECT_NEAR(slope, 2, 1e-12);
}

TEST(CubicSpline, of_a_period_knows_no_beginning) {
  std::vector<double> at;
  std::vector<double> values;
  for (int i = 0; i <= 50; ++i) at.push_back(2 * kPi * i / 50);
  for (int i = 0; i < 50; ++i) values.push_back(std::sin(at[static_cast<std::size_t>(i)] + 0.3));
  const std::vector<double> slopes = periodic_slopes(at, values);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(slopes[i], std::cos(at[i] + 0.3), 1e-5);
}

}  // namespace
}  // namespace kerf::drawing
