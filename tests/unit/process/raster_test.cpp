#include "process/raster.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "seeded_random.hpp"

namespace kerf::process {
namespace {

/// round(255 x / 15), 16 pixels wide.
GreyImage ramp(std::uint32_t rows = 8) {
  GreyImage image{16, rows, {}};
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (int x = 0; x < 16; ++x)
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * x / 15)));
  }
  return image;
}

Operation raster(Dither mode) {
  Operation operation;
  operation.name = "picture";
  operation.process = Process::raster;
  operation.mode = mode;
  return operation;
}

Settled settled(double power = 100, double feed = 3000) {
  Settled settled;
  settled.power_percent = power;
  settled.feed = feed;
  return settled;
}

struct Made {
  std::vector<ScanLine> lines;
  std::uint64_t burnt = 0;
  std::uint64_t runs = 0;
};

Made made(const GreyImage& image, const Operation& operation, Vec2 size,
          const Settled& how = settled()) {
  auto raster = Raster::make(image, operation, how, size);
  EXPECT_TRUE(raster.has_value());
  Made made;
  for (ScanLine line; raster->next(line);) made.lines.push_back(line);
  made.burnt = raster->burnt();
  made.runs = raster->runs();
  return made;
}

/// A row as it lies in the picture, `#` burnt, pixels of 0.1 mm.
std::string picture_of(const ScanLine& line, std::size_t columns) {
  std::string row(columns, '.');
  for (const auto& run : line.runs) {
    for (std::size_t x = 0; x < columns; ++x) {
      const double middle = (static_cast<double>(x) + 0.5) * 0.1;
      const double along = (middle - line.origin.u) * line.along.u;
      if (along > run.from && along < run.to) row[x] = '#';
    }
  }
  return row;
}

void expect_burnt(Dither mode, std::uint64_t pixels, std::uint64_t runs) {
  const Made all = made(ramp(), raster(mode), {1.6, 0.8});
  EXPECT_EQ(all.burnt, pixels);
  EXPECT_EQ(all.runs, runs);
  EXPECT_EQ(all.lines.size(), 8U);
  double length = 0;
  for (const ScanLine& line : all.lines) {
    for (const auto& run : line.runs) length += run.to - run.from;
  }
  EXPECT_NEAR(length, 0.1 * static_cast<double>(pixels), 1e-9);
}

TEST(Raster, a_ramp_burns_as_many_pixels_as_each_mode_says) {
  expect_burnt(Dither::threshold, 64, 8);
  expect_burnt(Dither::ordered_4, 60, 32);
  expect_burnt(Dither::ordered_8, 59, 33);
  expect_burnt(Dither::floyd_steinberg, 63, 32);
  expect_burnt(Dither::jarvis, 63, 28);
  expect_burnt(Dither::stucki, 62, 27);
}

TEST(Raster, floyd_and_steinberg_burn_the_ramp_row_by_row) {
  const char* const rows[] = {"######.#.#......", "####.#.#..#.#...", "#####.##.#......",
                              "###.##.#.#..#...", "####.##.#.#.....", "#####.#.#.......",
                              "###.##.#.#.#.#..", "#####.#.#......."};
  const Made all = made(ramp(), raster(Dither::floyd_steinberg), {1.6, 0.8});
  ASSERT_EQ(all.lines.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(picture_of(all.lines[i], 16), rows[i]) << i;
}

TEST(Raster, rows_go_to_and_fro_from_the_upper_edge_and_in_the_middle) {
  const Made all = made(ramp(), raster(Dither::threshold), {1.6, 0.8});
  for (std::size_t i = 0; i < 8; ++i) {
    const ScanLine& line = all.lines[i];
    EXPECT_NEAR(line.origin.v, 0.75 - 0.1 * static_cast<double>(i), 1e-12);
    ASSERT_EQ(line.runs.size(), 1U);
    const bool goes_back = i % 2 == 1;
    EXPECT_EQ(line.along, (goes_back ? Vec2{-1, 0} : Vec2{1, 0}));
    EXPECT_NEAR(line.origin.u, goes_back ? 1.6 : 0, 1e-12);
    EXPECT_NEAR(line.runs[0].from, goes_back ? 0.8 : 0, 1e-12);
    EXPECT_NEAR(line.runs[0].to, goes_back ? 1.6 : 0.8, 1e-12);
    EXPECT_EQ(line.runs[0].power, 1);
  }
}

TEST(Raster, rows_in_one_direction_all_go_to_the_right) {
  Operation operation = raster(Dither::threshold);
  operation.bidirectional = false;
  operation.scan_offset = {{1000, 0.5}};
  for (const ScanLine& line : made(ramp(), operation, {1.6, 0.8}).lines) {
    EXPECT_EQ(line.along, (Vec2{1, 0}));
    EXPECT_EQ(line.origin.u, 0);
  }
}

TEST(Raster, rows_that_go_back_are_moved_by_what_they_land_short) {
  Operation operation = raster(Dither::threshold);
  operation.scan_offset = {{1000, 0.1}, {5000, 0.3}};
  const auto origin = [&](double feed) {
    return made(ramp(), operation, {1.6, 0.8}, settled(100, feed)).lines[1].origin.u;
  };
  EXPECT_NEAR(origin(1000), 1.7, 1e-12);
  EXPECT_NEAR(origin(3000), 1.8, 1e-12);
  EXPECT_NEAR(origin(9000), 1.9, 1e-12);
  EXPECT_NEAR(origin(10), 1.7, 1e-12);
  EXPECT_EQ(made(ramp(), operation, {1.6, 0.8}).lines[0].origin.u, 0);
}

TEST(Raster, empty_rows_are_left_out_and_do_not_turn_the_direction) {
  GreyImage image{2, 4, {0, 0, 255, 255, 255, 255, 0, 0}};
  const Made all = made(image, raster(Dither::threshold), {0.2, 0.4});
  ASSERT_EQ(all.lines.size(), 2U);
  EXPECT_NEAR(all.lines[0].origin.v, 0.35, 1e-12);
  EXPECT_NEAR(all.lines[1].origin.v, 0.05, 1e-12);
  EXPECT_EQ(all.lines[1].along, (Vec2{-1, 0}));
}

TEST(Raster, the_level_of_threshold_is_the_first_grey_that_does_not_burn) {
  const auto burnt = [](std::uint32_t level) {
    Operation operation = raster(Dither::threshold);
    operation.level = level;
    return made({3, 1, {0, 127, 128}}, operation, {0.3, 0.1}).burnt;
  };
  EXPECT_EQ(burnt(0), 0U);
  EXPECT_EQ(burnt(127), 1U);
  EXPECT_EQ(burnt(128), 2U);
  EXPECT_EQ(burnt(129), 3U);
}

TEST(Raster, grey_is_power_along_a_curve_in_steps_of_a_thousandth) {
  Operation operation = raster(Dither::grey);
  operation.min_power_percent = 10;
  operation.curve = {{0, 0}, {0.5, 0.2}, {1, 1}};
  const GreyImage image{6, 1, {0, 51, 51, 102, 204, 255}};
  const Made all = made(image, operation, {0.6, 0.1}, settled(60));
  ASSERT_EQ(all.lines.size(), 1U);
  const auto& runs = all.lines[0].runs;
  ASSERT_EQ(runs.size(), 4U);  // the two of 51 are one, white is off
  EXPECT_NEAR(runs[0].power * 60, 60, 1e-9);
  EXPECT_NEAR(runs[1].power * 60, 10 + 50 * 0.68, 1e-9);
  EXPECT_NEAR(runs[1].from, 0.1, 1e-12);
  EXPECT_NEAR(runs[1].to, 0.3, 1e-12);
  EXPECT_NEAR(runs[2].power * 60, 10 + 50 * 0.36, 1e-9);
  EXPECT_NEAR(runs[3].power * 60, 10 + 50 * 0.08, 1e-9);
  operation.curve = {{0, 0}, {1, 1}};
  operation.min_power_percent = 0;
  const auto odd = made({1, 1, {100}}, operation, {0.1, 0.1}, settled(33.3)).lines[0].runs[0];
  EXPECT_NEAR(odd.power * 33.3, 20.2, 1e-9);  // 33.3 · 155 / 255 = 20.24
}

TEST(Raster, the_mean_of_a_dithered_picture_is_that_of_the_picture) {
  test::SeededRandom random{7};
  for (const Dither mode :
       {Dither::floyd_steinberg, Dither::jarvis, Dither::stucki, Dither::ordered_8}) {
    GreyImage image{128, 128, {}};
    double sum = 0;
    const double base = random.in(0, 200);
    for (int i = 0; i < 128 * 128; ++i) {
      image.pixels.push_back(static_cast<std::uint8_t>(base + random.in(0, 50)));
      sum += 1 - image.pixels.back() / 255.0;
    }
    const Made all = made(image, raster(mode), {12.8, 12.8});
    // What leaves the picture at its edges is lost.
    EXPECT_NEAR(static_cast<double>(all.burnt), sum, 128 * 128 * 0.015);
  }
}

TEST(Raster, a_picture_of_another_size_is_averaged_by_area) {
  Operation operation = raster(Dither::grey);
  // Two pixels make one, and rows of three one of two.
  const GreyImage image{4, 3, {0, 100, 200, 0, 10, 110, 210, 10, 20, 120, 220, 20}};
  const Made all = made(image, operation, {0.2, 0.2});
  ASSERT_EQ(all.lines.size(), 2U);
  const auto share = [](double grey) { return std::round(1000 * (255 - grey) / 255) / 1000; };
  // Above: the first row and half of the second; below: half of the second and the third.
  const double first = (0 + 100 + 0.5 * (10 + 110)) / 3;
  const double second = (200 + 0 + 0.5 * (210 + 10)) / 3;
  ASSERT_EQ(all.lines[0].runs.size(), 2U);
  EXPECT_NEAR(all.lines[0].runs[0].power, share(first), 1e-9);
  EXPECT_NEAR(all.lines[0].runs[1].power, share(second), 1e-9);
  EXPECT_NEAR(all.lines[1].runs[1].power, share(first + 40.0 / 3), 1e-9);
  // Larger: every pixel is four.
  const Made large = made(image, operation, {0.8, 0.6});
  EXPECT_EQ(large.lines.size(), 6U);
  EXPECT_NEAR(large.lines[0].runs[1].from, 0.2, 1e-12);
  EXPECT_NEAR(large.lines[0].runs[1].power, share(100), 1e-9);
}

TEST(Raster, pixels_along_the_row_may_be_shorter_than_rows_are_apart) {
  Operation operation = raster(Dither::threshold);
  operation.pixel = 0.05;
  operation.interval = 0.2;
  const GreyImage image = ramp();
  auto raster = Raster::make(image, operation, settled(), {1.6, 0.8});
  EXPECT_EQ(raster->columns(), 32U);
  EXPECT_EQ(raster->rows(), 4U);
  ScanLine line;
  ASSERT_TRUE(raster->next(line));
  EXPECT_NEAR(line.runs[0].to, 0.8, 1e-12);
  EXPECT_NEAR(line.origin.v, 0.7, 1e-12);
}

double power_of(const Operation& operation, std::uint8_t grey) {
  const Made all = made({1, 1, {grey}}, operation, {0.1, 0.1});
  return all.lines.empty() ? 0 : all.lines[0].runs[0].power;
}

TEST(Raster, greys_are_inverted_raised_made_lighter_and_harder) {
  Operation operation = raster(Dither::grey);
  operation.invert = true;
  EXPECT_EQ(power_of(operation, 255), 1);
  EXPECT_EQ(power_of(operation, 0), 0);
  EXPECT_NEAR(power_of(operation, 51), 0.2, 1e-9);
  operation.invert = false;
  operation.gamma = 2;
  EXPECT_NEAR(power_of(operation, 64), std::round(1000 * (1 - std::sqrt(64 / 255.0))) / 1000, 1e-9);
  operation.gamma = 1;
  operation.brightness = 20;
  EXPECT_NEAR(power_of(operation, 51), 0.6, 1e-9);
  operation.brightness = 0;
  operation.contrast = 100;
  EXPECT_NEAR(power_of(operation, 102), 0.7, 1e-9);
  EXPECT_EQ(power_of(operation, 20), 1);
  operation.contrast = -100;
  EXPECT_NEAR(power_of(operation, 3), 0.5, 1e-9);
}

TEST(Raster, a_mirrored_picture_burns_on_the_other_side) {
  Operation operation = raster(Dither::threshold);
  operation.mirror = true;
  const Made all = made(ramp(1), operation, {1.6, 0.1});
  EXPECT_NEAR(all.lines[0].runs[0].from, 0.8, 1e-12);
  EXPECT_NEAR(all.lines[0].runs[0].to, 1.6, 1e-12);
}

TEST(Raster, refuses_more_pixels_than_anybody_can_burn) {
  Operation operation = raster(Dither::threshold);
  operation.interval = 0.001;
  const GreyImage image = ramp();
  const auto raster = Raster::make(image, operation, settled(), {1000, 1000});
  ASSERT_FALSE(raster.has_value());
  EXPECT_EQ(raster.error().number, "JOB_VALUE");
  EXPECT_NE(raster.error().message.find("operation picture"), std::string::npos);
}

}  // namespace
}  // namespace kerf::process
