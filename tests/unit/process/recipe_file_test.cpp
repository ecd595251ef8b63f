#include "process/recipe_file.hpp"

#include <gtest/gtest.h>

#include "job_files.hpp"
#include "process/keys.hpp"

namespace kerf::process {
namespace {

TEST(RecipeFile, every_key_reaches_what_it_is_for) {
  const Recipe r = recipe_of(kAllKeys);
  EXPECT_EQ(r.source, "a.toml");
  EXPECT_EQ(r.machine, "laser5");
  EXPECT_EQ(r.material, "co2-paper");
  EXPECT_EQ(r.tolerance, 0.02);
  EXPECT_EQ(r.join, 0.3);
  EXPECT_EQ(r.same, 0.004);
  EXPECT_FALSE(r.by_travel);
  EXPECT_EQ(r.end.kind, EndKind::point);
  EXPECT_EQ(r.end.at, (Vec2{3, 4}));
  EXPECT_EQ(r.lens_side, "L");
  EXPECT_EQ(r.place.fit, (std::array<double, 2>{100, 50}));
  EXPECT_EQ(r.place.mirror, Mirror::y);
  EXPECT_EQ(r.place.rotate_deg, 30);
  EXPECT_EQ(r.place.anchor, Anchor::upper_centre);
  EXPECT_EQ(r.place.at, (Vec2{1, 2}));
  EXPECT_EQ(r.array.columns, 3U);
  EXPECT_EQ(r.array.rows, 2U);
  EXPECT_EQ(r.array.dx, 45);
  EXPECT_EQ(r.array.dy, -30);
  EXPECT_TRUE(r.array.is_mixed);
  EXPECT_EQ(r.image.width, 30);
  EXPECT_EQ(r.image.height, 40);
}

TEST(RecipeFile, every_key_of_texts_and_surfaces_reaches_what_it_is_for) {
  const Recipe r = recipe_of(kAllKeys);
  EXPECT_TRUE(r.text.is_said);
  EXPECT_EQ(r.text.font, "a.ttf");
  EXPECT_EQ(r.text.height, 7);
  EXPECT_EQ(r.text.spacing, 1.5);
  EXPECT_EQ(r.text.align, "center");
  EXPECT_EQ(r.text.serial_start, 12U);
  EXPECT_EQ(r.text.serial_step, 2U);
  EXPECT_EQ(r.text.serial_width, 3U);
  EXPECT_EQ(r.text.serial_keep, "serial.txt");
  ASSERT_EQ(r.text.lines.size(), 1U);
  EXPECT_EQ(r.text.lines[0].words, "No. {serial}");
  EXPECT_EQ(r.text.lines[0].at, (Vec2{5, 6}));
  EXPECT_EQ(r.text.lines[0].rotate_deg, 90);
  EXPECT_EQ(r.text.lines[0].layer, "marks");
  EXPECT_EQ(r.text.lines[0].height, 3);
  EXPECT_EQ(r.wrap.shape, Wrap::Shape::cone);
  EXPECT_EQ(r.wrap.axis, 'Z');
  EXPECT_EQ(r.wrap.radius, 20);
  EXPECT_EQ(r.wrap.centre, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(r.wrap.half_angle_deg, 15);
  EXPECT_EQ(r.wrap.at, 40);
  EXPECT_EQ(r.wrap.clearance, 8);
  EXPECT_EQ(r.wrap.normal_deg, 0.25);
}

TEST(RecipeFile, every_key_of_all_operations_reaches_what_it_is_for) {
  const Recipe r = recipe_of(kAllKeys);
  ASSERT_EQ(r.operations.size(), 6U);
  const Operation& o = r.operations[0];
  EXPECT_EQ(o.name, "outline");
  EXPECT_EQ(o.layers, (std::vector<std::string>{"CUT", "#ff0000"}));
  EXPECT_EQ(o.process, Process::cut);
  EXPECT_TRUE(o.enabled);
  EXPECT_EQ(o.line, 30U);
  EXPECT_EQ(o.power_percent, 80);
  EXPECT_EQ(o.frequency_hz, 1000);
  EXPECT_EQ(o.feed, 900);
  EXPECT_EQ(o.beam, Beam::follow);
  EXPECT_EQ(o.passes, 2U);
  EXPECT_EQ(o.z_step, -0.5);
  EXPECT_EQ(o.z, 1.5);
  EXPECT_EQ(o.pass_order, PassOrder::operation);
  EXPECT_EQ(o.air, Air::flood);
  EXPECT_EQ(o.gas, "N2");
  EXPECT_EQ(o.start, StartAt::corner);
  EXPECT_TRUE(o.dashes);
  EXPECT_EQ(o.overlaps, Overlaps::once);
  EXPECT_EQ(o.min_power_percent, 5);
  EXPECT_EQ(o.depth, 3);
  EXPECT_EQ(o.step_down, 1);
  EXPECT_EQ(o.safe_z, 10);
  EXPECT_EQ(o.plunge, 100);
  EXPECT_EQ(o.tool, 4U);
  EXPECT_EQ(o.spindle, 12000);
}

TEST(RecipeFile, every_key_of_cutting_reaches_what_it_is_for) {
  const Operation o = recipe_of(kAllKeys).operations.at(0);
  EXPECT_EQ(o.overcut, 0.3);
  EXPECT_EQ(o.kerf, 0.15);
  EXPECT_EQ(o.side, CutSide::inside);
  EXPECT_EQ(o.corner, CutCorner::sharp);
  EXPECT_EQ(o.lead_in.kind, Lead::Kind::line);
  EXPECT_EQ(o.lead_in.length_mm, 2);
  EXPECT_EQ(o.lead_in.angle_deg, 45);
  EXPECT_EQ(o.lead_out.kind, Lead::Kind::arc);
  EXPECT_EQ(o.lead_out.radius_mm, 1.5);
  EXPECT_EQ(o.lead_out.angle_deg, 90);
  EXPECT_TRUE(o.lead_open);
  EXPECT_EQ(o.pierce_s, 0.4);
  EXPECT_EQ(o.pierce_power_percent, 90);
  EXPECT_EQ(o.tabs.count, 4U);
  EXPECT_EQ(o.tabs.width_mm, 0.5);
  EXPECT_EQ(o.tabs.power_percent, 10);
}

TEST(RecipeFile, every_key_of_fill_and_raster_reaches_what_it_is_for) {
  const Recipe r = recipe_of(kAllKeys);
  const Operation& fill = r.operations.at(1);
  EXPECT_EQ(fill.layers, std::vector<std::string>{"FILL"});
  EXPECT_FALSE(fill.enabled);
  EXPECT_EQ(fill.ton_ms, 0.4);
  EXPECT_EQ(fill.toff_ms, 0.1);
  EXPECT_EQ(fill.ms_per_mm, 5);
  EXPECT_EQ(fill.spacing, 0.2);
  EXPECT_EQ(fill.angle_deg, 45);
  EXPECT_TRUE(fill.cross);
  EXPECT_EQ(fill.fill_kind, FillKind::offset);
  EXPECT_EQ(fill.inset, 0.1);
  EXPECT_FALSE(fill.bidirectional);
  EXPECT_EQ(fill.overscan, 3);
  EXPECT_TRUE(fill.outline);
  const Operation& raster = r.operations.at(2);
  EXPECT_EQ(raster.layers, std::vector<std::string>{"*"});
  EXPECT_EQ(raster.interval, 0.05);
  EXPECT_EQ(raster.pixel, 0.04);
  EXPECT_EQ(raster.mode, Dither::stucki);
  EXPECT_EQ(raster.level, 100U);
  using Pairs = std::vector<std::pair<double, double>>;
  EXPECT_EQ(raster.scan_offset, (Pairs{{1000, 0.05}, {6000, 0.2}}));
  EXPECT_EQ(raster.curve, (Pairs{{0, 0.1}, {0.5, 0.4}, {1, 1}}));
  EXPECT_TRUE(raster.invert && raster.mirror);
  EXPECT_EQ(raster.gamma, 1.8);
  EXPECT_EQ(raster.brightness, -10);
  EXPECT_EQ(raster.contrast, 20);
  EXPECT_FALSE(raster.overscan);
}

TEST(RecipeFile, every_key_of_weld_heat_and_drill_reaches_what_it_is_for) {
  const Recipe r = recipe_of(kAllKeys);
  const Operation& weld = r.operations.at(3);
  EXPECT_EQ(weld.ramp_in, 3);
  EXPECT_EQ(weld.ramp_out, 4);
  EXPECT_EQ(weld.close, 1);
  EXPECT_EQ(weld.weave.shape, Weave::Shape::circle);
  EXPECT_EQ(weld.weave.width_mm, 1);
  EXPECT_EQ(weld.weave.pitch_mm, 2);
  EXPECT_EQ(r.operations.at(4).track_width, 5);
  EXPECT_EQ(r.operations.at(4).overlap, 0.3);
  const Operation& drill = r.operations.at(5);
  EXPECT_EQ(drill.max_diameter, 3);
  EXPECT_EQ(drill.pulses, 500U);
  EXPECT_TRUE(drill.trepan);
}

TEST(RecipeFile, the_keys_above_are_all) {
  // What stands instead of others has tests of its own, and so have materials.
  const std::string others = "scale count angle center dpi dwell_s spacing";
  for (const JobKey& key : job_keys()) {
    if (key.table == KeyTable::material || key.table == KeyTable::preset) continue;
    const std::string name{key.name};
    EXPECT_TRUE(std::string(kAllKeys).find(name + " = ") != std::string::npos ||
                others.find(name) != std::string::npos)
        << name;
    EXPECT_FALSE(key.about.empty());
    EXPECT_TRUE(key.about.ends_with("."));
  }
}

TEST(RecipeFile, what_stands_instead_of_others_is_read) {
  const Recipe r = recipe_of(
      "place.scale = [2, 3]\n"
      "array = {count = 6, angle = 60, center = [1, 2]}\n"
      "image.dpi = 300\n"
      "operation = [{process = 'drill', dwell_s = 0.5, kerf = 0.1},"
      " {process = 'cut', tabs = {spacing = 30, width = 1}}]\n");
  EXPECT_EQ(r.place.scale, (std::array<double, 2>{2, 3}));
  EXPECT_EQ(r.array.count, 6U);
  EXPECT_EQ(r.array.angle_deg, 60);
  EXPECT_EQ(r.array.centre, (Vec2{1, 2}));
  EXPECT_EQ(r.array.copies(), 6U);
  EXPECT_EQ(r.image.dpi, 300);
  EXPECT_EQ(r.operations.at(0).dwell_s, 0.5);
  EXPECT_EQ(r.operations.at(1).tabs.spacing_mm, 30);
}

TEST(RecipeFile, both_spellings_of_a_table_are_the_same) {
  const Recipe one = recipe_of("job = {material = \"x\"}\nplace = {scale = 2}\n");
  const Recipe other = recipe_of("[job]\r\nmaterial = \"x\"\r\n[place]\r\nscale = 2.0\r\n");
  EXPECT_EQ(one.material, "x");
  EXPECT_EQ(other.material, "x");
  EXPECT_EQ(one.place.scale, (std::array<double, 2>{2, 2}));
  EXPECT_EQ(other.place.scale, one.place.scale);
}

TEST(RecipeFile, operations_without_a_name_have_one_each) {
  const Recipe r = recipe_of("[[operation]]\n[[operation]]\nprocess='cut'\n[[operation]]\n");
  ASSERT_EQ(r.operations.size(), 3U);
  EXPECT_EQ(r.operations[0].name, "engrave");
  EXPECT_EQ(r.operations[1].name, "cut");
  EXPECT_EQ(r.operations[2].name, "engrave 2");
}

}  // namespace
}  // namespace kerf::process
