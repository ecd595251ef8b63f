#include <gtest/gtest.h>

#include "job_files.hpp"
#include "process/keys.hpp"
#include "process/settled.hpp"

namespace kerf::process {
namespace {

TEST(JobSet, changes_a_key) {
  Recipe r = recipe_of(kAllKeys);
  EXPECT_EQ(wrong_setting(r, "operation.outline.feed", "600"), "");
  EXPECT_EQ(r.operations[0].feed, 600);
  EXPECT_EQ(wrong_setting(r, "operation.2.spacing", "0.3"), "");
  EXPECT_EQ(r.operations[1].spacing, 0.3);
  EXPECT_EQ(wrong_setting(r, "operation.outline.lead_in.length", "7"), "");
  EXPECT_EQ(r.operations[0].lead_in.length_mm, 7);
  EXPECT_EQ(r.operations[0].lead_in.angle_deg, 45);
  EXPECT_EQ(wrong_setting(r, "operation.outline.tabs", "{count = 8, power = 3}"), "");
  EXPECT_EQ(r.operations[0].tabs.count, 8U);
  EXPECT_EQ(r.operations[0].tabs.width_mm, 0.5);
  EXPECT_EQ(wrong_setting(r, "place.scale", "[2, 3]"), "");
  EXPECT_EQ(r.place.scale, (std::array<double, 2>{2, 3}));
  EXPECT_EQ(wrong_setting(r, "lens.side", "R"), "");
  EXPECT_EQ(r.lens_side, "R");
  EXPECT_EQ(wrong_setting(r, "job.material", "\"co2 paper\""), "");
  EXPECT_EQ(r.material, "co2 paper");
  EXPECT_EQ(wrong_setting(r, "job.end", "stay"), "");
  EXPECT_EQ(r.end.kind, EndKind::stay);
  EXPECT_EQ(wrong_setting(r, "text.serial.start", "40"), "");
  EXPECT_EQ(r.text.serial_start, 40U);
  EXPECT_EQ(wrong_setting(r, "text.line.1.text", "12"), "");
  EXPECT_EQ(r.text.lines[0].words, "12");
  EXPECT_EQ(wrong_setting(r, "operation.outline.layers", "#00ff00"), "");
  EXPECT_EQ(r.operations[0].layers, std::vector<std::string>{"#00ff00"});
}

TEST(JobSet, makes_room_for_what_stands_instead) {
  Recipe r = recipe_of(kAllKeys);
  EXPECT_EQ(wrong_setting(r, "operation.area.power", "40"), "");
  EXPECT_FALSE(r.operations[1].ton_ms || r.operations[1].toff_ms);
  EXPECT_EQ(wrong_setting(r, "operation.area.feed", "40"), "");
  EXPECT_FALSE(r.operations[1].ms_per_mm);
  EXPECT_EQ(wrong_setting(r, "operation.outline.ton_ms", "1"), "");
  EXPECT_FALSE(r.operations[0].power_percent || r.operations[0].frequency_hz);
  EXPECT_EQ(told(contradictions(r)),
            "0:0 JOB_VALUE: operation outline: ton_ms and toff_ms are said together\n");
  EXPECT_EQ(wrong_setting(r, "operation.outline.toff_ms", "1"), "");
  EXPECT_EQ(told(contradictions(r)), "");
}

TEST(JobSet, tells_what_is_wrong_and_changes_nothing) {
  Recipe r = recipe_of(kAllKeys);
  EXPECT_EQ(wrong_setting(r, "operation.outline.fed", "600"),
            "0:0 JOB_KEY: [[operation]] has no key fed (feed is the nearest name)\n");
  EXPECT_EQ(wrong_setting(r, "operation.outlin.feed", "600"),
            "0:0 JOB_KEY: there is no operation outlin (outline is the nearest name)\n");
  EXPECT_EQ(wrong_setting(r, "operation.7.feed", "600"), "0:0 JOB_KEY: there is no operation 7\n");
  EXPECT_EQ(wrong_setting(r, "operation.outline.spacing", "1"),
            "0:0 JOB_KEY: spacing is a key of fill, and this operation is cut\n");
  EXPECT_EQ(wrong_setting(r, "operation.outline.power", "eighty"),
            "0:0 JOB_VALUE: power is a number from 0 to 100, not \"eighty\"\n");
  EXPECT_EQ(wrong_setting(r, "operation.outline.power", "80\nfeed = 3"),
            "0:0 JOB_VALUE: power is a number from 0 to 100, not \"80\nfeed = 3\"\n");
  EXPECT_EQ(wrong_setting(r, "operation.outline.lead_in", "{kind = 'arc', radius = -1}"),
            "0:0 JOB_VALUE: radius is a number from 0 to 1000, not -1\n");
  EXPECT_EQ(r.operations[0].lead_in.kind, Lead::Kind::line);
  for (const char* const key : {"", ".", "feed", "operation", "operation.", "operation.outline",
                                "operation.outline.", "text.line.2.text", "place", "job.."})
    EXPECT_NE(wrong_setting(r, key, "1"), "") << key;
  EXPECT_EQ(r.operations[0].feed, 900);
}

TEST(Keys, words_stand_in_the_order_of_their_enum) {
  Recipe r = recipe_of("[[operation]]\n");
  for (const Process process : {Process::engrave, Process::mark, Process::cut, Process::fill,
                                Process::raster, Process::weld, Process::heat, Process::drill}) {
    EXPECT_EQ(wrong_setting(r, "operation.1.process", name_of(process)), "");
    EXPECT_EQ(r.operations[0].process, process);
  }
  EXPECT_EQ(wrong_setting(r, "operation.1.process", "raster"), "");
  const std::pair<const char*, Dither> modes[] = {{"threshold", Dither::threshold},
                                                  {"ordered-2", Dither::ordered_2},
                                                  {"ordered-4", Dither::ordered_4},
                                                  {"ordered-8", Dither::ordered_8},
                                                  {"jarvis", Dither::jarvis},
                                                  {"floyd-steinberg", Dither::floyd_steinberg},
                                                  {"grey", Dither::grey}};
  for (const auto& [word, mode] : modes) {
    EXPECT_EQ(wrong_setting(r, "operation.1.mode", word), "");
    EXPECT_EQ(r.operations[0].mode, mode) << word;
  }
  const std::pair<const char*, Anchor> anchors[] = {{"origin", Anchor::origin},
                                                    {"lower-left", Anchor::lower_left},
                                                    {"lower-center", Anchor::lower_centre},
                                                    {"lower-right", Anchor::lower_right},
                                                    {"center-left", Anchor::centre_left},
                                                    {"center", Anchor::centre},
                                                    {"center-right", Anchor::centre_right},
                                                    {"upper-left", Anchor::upper_left},
                                                    {"upper-right", Anchor::upper_right}};
  for (const auto& [word, anchor] : anchors) {
    EXPECT_EQ(wrong_setting(r, "place.anchor", word), "");
    EXPECT_EQ(r.place.anchor, anchor) << word;
  }
}

}  // namespace
}  // namespace kerf::process
