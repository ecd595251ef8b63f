#include "process/materials.hpp"

#include <gtest/gtest.h>

#include "process/settled.hpp"

namespace kerf::process {
namespace {

constexpr base::FileId kFile{3};

MachineFacts laser_of(double watts) {
  MachineFacts machine;
  machine.name = "laser3";
  machine.has_beam = true;
  machine.max_power_w = watts;
  machine.fastest_feed = 12000;
  machine.kerf_mm = 0.1;
  return machine;
}

Operation operation_of(Process process) {
  Operation operation;
  operation.name = "a";
  operation.process = process;
  return operation;
}

const Material& builtin(std::string_view name) {
  const auto found = find_material(name, {}, {});
  EXPECT_TRUE(found.has_value()) << name;
  return **found;
}

TEST(Materials, those_that_kerf_knows_are_read) {
  std::string names;
  for (const Material& each : builtin_materials()) names += each.name + " ";
  EXPECT_EQ(names,
            "co2-plywood-3 co2-acrylic-3 co2-mdf-3 co2-card-1.5 co2-leather-2 co2-paper co2-glass "
            "fibre-steel-1 fibre-stainless-1 fibre-aluminium-1 fibre-c45 wheel-glass ");
  for (const BuiltinMaterials& file : builtin_material_files())
    EXPECT_TRUE(read_materials(std::string(file.toml), "-", kFile).has_value()) << file.name;
}

TEST(Materials, fill_what_an_operation_leaves_out) {
  Operation cut = operation_of(Process::cut);
  EXPECT_TRUE(fill_in(cut, &builtin("co2-plywood-3"), laser_of(60)).empty());
  EXPECT_EQ(cut.power_percent, 80);
  EXPECT_EQ(cut.feed, 900);
  Operation fill = operation_of(Process::fill);  // as engrave
  EXPECT_TRUE(fill_in(fill, &builtin("co2-plywood-3"), laser_of(60)).empty());
  EXPECT_EQ(fill.power_percent, 20);
  EXPECT_EQ(fill.feed, 6000);
  EXPECT_EQ(fill.spacing, 0.1);
  Operation heat = operation_of(Process::heat);
  EXPECT_TRUE(fill_in(heat, &builtin("fibre-c45"), laser_of(1000)).empty());
  EXPECT_EQ(heat.power_percent, 100);
  EXPECT_EQ(heat.track_width, 5);
  // 25 J/mm²: P / (v · width)
  EXPECT_NEAR(1000 / (*heat.feed / 60 * *heat.track_width), 25, 1e-9);
}

TEST(Materials, leave_what_an_operation_says) {
  Operation cut = operation_of(Process::cut);
  cut.power_percent = 33;
  cut.ms_per_mm = 20;
  cut.gas = "air";
  EXPECT_TRUE(fill_in(cut, &builtin("co2-plywood-3"), laser_of(60)).empty());
  EXPECT_EQ(cut.power_percent, 33);
  EXPECT_FALSE(cut.feed);
  EXPECT_EQ(settle(cut, laser_of(60)).feed, 3000);
  Operation pulsed = operation_of(Process::cut);
  pulsed.ton_ms = 0.4;
  pulsed.toff_ms = 0.1;
  EXPECT_TRUE(fill_in(pulsed, &builtin("co2-plywood-3"), laser_of(60)).empty());
  EXPECT_FALSE(pulsed.power_percent);
  EXPECT_EQ(settle(pulsed, laser_of(60)).power_percent, 80);
}

TEST(Materials, of_more_watts_than_there_are_make_the_feed_slower) {
  Operation cut = operation_of(Process::cut);
  cut.place = {kFile, 7, 1};
  const Diagnostics found = fill_in(cut, &builtin("co2-plywood-3"), laser_of(40));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].number, "PRESET_SCALED");
  EXPECT_EQ(found[0].severity, base::Severity::warning);
  EXPECT_EQ(found[0].place.line, 7U);
  EXPECT_NE(found[0].message.find("48 W, and laser3 has 40; its feed is 750 instead of 900"),
            std::string::npos)
      << found[0].message;
  EXPECT_EQ(cut.power_percent, 100);
  EXPECT_EQ(cut.feed, 750);
  // Energy a millimetre stays.
  EXPECT_NEAR(40 / *cut.feed, 48.0 / 900, 1e-12);
  Operation fixed = operation_of(Process::cut);
  fixed.feed = 900;
  EXPECT_NE(fill_in(fixed, &builtin("co2-plywood-3"), laser_of(40)).at(0).message.find("stays"),
            std::string::npos);
  EXPECT_EQ(fixed.feed, 900);
}

TEST(Materials, all_of_a_preset_reaches_the_operation) {
  const auto read = read_materials(
      "[[material]]\nname = 'x'\ntext = 'y'\nthickness = 2\n"
      "[material.cut]\npower_w = 30\nfeed = 100\nkerf = 0.3\npasses = 2\nfrequency_hz = 500\n"
      "gas = 'O2'\npierce_s = 0.2\nfocus = -1\nspacing = 0.4\ntrack_width = 6\ndepth = 1.5\n",
      "m.toml", kFile);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->at(0).text, "y");
  EXPECT_EQ(read->at(0).thickness, 2);
  Operation cut = operation_of(Process::cut);
  EXPECT_TRUE(fill_in(cut, &read->at(0), laser_of(60)).empty());
  EXPECT_EQ(cut.power_percent, 50);
  EXPECT_EQ(cut.kerf, 0.3);
  EXPECT_EQ(cut.passes, 2U);
  EXPECT_EQ(cut.frequency_hz, 500);
  EXPECT_EQ(cut.gas, "O2");
  EXPECT_EQ(cut.pierce_s, 0.2);
  EXPECT_EQ(cut.z, -1);
  EXPECT_EQ(cut.spacing, 0.4);
  EXPECT_EQ(cut.interval, 0.4);
  EXPECT_EQ(cut.track_width, 6);
  EXPECT_EQ(cut.depth, 1.5);
}

TEST(Materials, do_not_change_a_default_that_the_job_says_itself) {
  const auto material = read_materials(
      "[[material]]\nname = 'x'\ncut = {passes = 3, pierce_s = 2}\n", "m.toml", kFile);
  auto recipe = read_recipe(
      "job = {material = 'x'}\n"
      "operation = [{process = 'cut', passes = 1, pierce_s = 0}, {process = 'cut', name = 'b'}]\n",
      "a.toml", kFile);
  ASSERT_TRUE(recipe && material);
  EXPECT_TRUE(fill_in(*recipe, *material, laser_of(60)).empty());
  EXPECT_EQ(recipe->operations[0].passes, 1U);
  EXPECT_EQ(recipe->operations[0].pierce_s, 0);
  EXPECT_EQ(recipe->operations[1].passes, 3U);
  EXPECT_EQ(recipe->operations[1].pierce_s, 2);
}

TEST(Materials, of_a_file_go_before_those_that_kerf_knows) {
  const auto read = read_materials(
      "material = [{name = 'co2-paper', cut = {feed = 5}}, {name = 'co2-paper', cut = {feed = 6}}]",
      "m.toml", kFile);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ((*find_material("co2-paper", *read, {}))->presets[0].feed, 6);
}

TEST(Materials, an_unknown_one_is_told_with_the_nearest_name) {
  auto recipe = read_recipe("[job]\nmaterial = 'co2-plywod-3'\n[[operation]]\n", "a.toml", kFile);
  ASSERT_TRUE(recipe.has_value());
  const Diagnostics found = fill_in(*recipe, {}, laser_of(60));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].number, "MATERIAL_UNKNOWN");
  EXPECT_EQ(found[0].place.line, 2U);
  EXPECT_EQ(found[0].hint, "co2-plywood-3 is the nearest name");
}

TEST(Materials, of_a_track_without_a_width_is_told) {
  Operation heat = operation_of(Process::heat);
  const Diagnostics found = fill_in(heat, &builtin("co2-paper"), laser_of(60));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].message.find("track_width"), std::string::npos);
}

TEST(Materials, a_file_with_mistakes_is_told_by_line_and_column) {
  const auto read = read_materials(
      "[[material]]\nname = 'x'\ncut = {powr_w = 3}\n[[material]]\nweld = {feed = -1}\n[fabric]\n",
      "m.toml", kFile);
  ASSERT_FALSE(read.has_value());
  std::string told;
  for (const base::Diagnostic& each : read.error()) {
    told += std::to_string(each.place.line) + ":" + std::to_string(each.place.column) + " " +
            each.number + " " + each.hint + "\n";
  }
  EXPECT_EQ(told,
            "3:8 JOB_KEY power_w is the nearest name\n4:1 JOB_VALUE \n5:16 JOB_VALUE \n"
            "6:2 JOB_KEY \n");
}

}  // namespace
}  // namespace kerf::process
