#include <gtest/gtest.h>

#include "job_files.hpp"

namespace kerf::process {
namespace {

TEST(RecipeFile, tells_an_unknown_key_with_its_place_and_the_nearest_name) {
  EXPECT_EQ(wrong_in("\n[[operation]]\n  fed = 3\n"),
            "3:3 JOB_KEY: [[operation]] has no key fed (feed is the nearest name)\n");
  EXPECT_EQ(wrong_in("job = {tolernace = 1}\n"),
            "1:8 JOB_KEY: [job] has no key tolernace (tolerance is the nearest name)\n");
  EXPECT_EQ(wrong_in("[plac]\nat = [0, 0]\n"),
            "1:2 JOB_KEY: there is no table plac (place is the nearest name)\n");
  EXPECT_EQ(wrong_in("[text]\nseriel = {}\n"),
            "2:1 JOB_KEY: [text] has no key seriel (serial is the nearest name)\n");
  EXPECT_EQ(wrong_in("[wrap]\nxyzzyqqq = 1\n"), "2:1 JOB_KEY: [wrap] has no key xyzzyqqq\n");
  EXPECT_EQ(wrong_in("[[operation]]\nprocess='cut'\nlead_in = {lenght = 2}\n"),
            "3:12 JOB_KEY: a lead has no key lenght (length is the nearest name)\n");
}

TEST(RecipeFile, tells_a_key_that_the_process_does_not_take) {
  EXPECT_EQ(wrong_in("[[operation]]\npierce_s = 1\nprocess = \"fill\"\n"),
            "2:1 JOB_KEY: pierce_s is a key of cut, and this operation is fill\n");
  EXPECT_EQ(wrong_in("[[operation]]\nprocess = \"cut\"\nangle = 1\n"),
            "3:1 JOB_KEY: angle is a key of fill or heat, and this operation is cut\n");
  EXPECT_EQ(wrong_in("[[operation]]\nprocess = \"weld\"\novercut = 1\n"),
            "3:1 JOB_KEY: overcut is a key of engrave, mark or cut, and this operation is weld\n");
}

TEST(RecipeFile, tells_a_value_out_of_range_with_the_range) {
  EXPECT_EQ(wrong_in("[[operation]]\npower = 101\nfeed = -5\npasses = 1.5\n"),
            "2:9 JOB_VALUE: power is a number from 0 to 100, not 101\n"
            "3:8 JOB_VALUE: feed is a number from 0.001 to 1000000, not -5\n"
            "4:10 JOB_VALUE: passes is a whole number from 1 to 10000, not 1.5\n");
  EXPECT_EQ(
      wrong_in("[[operation]]\nbeam = \"folow\"\ndashes = 1\nz = nan\nname = \"\"\n"),
      "2:8 JOB_VALUE: beam is constant or follow, not \"folow\" (follow is the nearest name)\n"
      "3:10 JOB_VALUE: dashes is true or false, not 1\n"
      "4:5 JOB_VALUE: z is a number from -1000000 to 1000000, not nan\n"
      "5:8 JOB_VALUE: name is a text of at most 1000 bytes, not \"\"\n");
  EXPECT_EQ(wrong_in("text = {height = 0}\n"),
            "1:18 JOB_VALUE: height is a number above 0, up to 1000000, not 0\n");
  EXPECT_EQ(wrong_in("job = {end = [1, 2, 3]}\nplace = 7\n"),
            "1:14 JOB_VALUE: end is origin or stay, or [x, y], not this list\n"
            "2:9 JOB_VALUE: [place] is a table, not 7\n");
  EXPECT_EQ(wrong_in("[operation]\nfeed = 5\n"),
            "1:1 JOB_VALUE: [[operation]] tables are expected\n");
}

TEST(RecipeFile, tells_what_is_no_toml) {
  const std::string told = wrong_in("[job]\nmaterial = = 3\n");
  EXPECT_TRUE(told.starts_with("2:12 JOB_VALUE: ")) << told;
}

TEST(RecipeFile, tells_what_does_not_go_together) {
  const std::string operation = "[[operation]]\nprocess = 'cut'\n";
  EXPECT_EQ(wrong_in(operation + "power = 5\nton_ms = 1\ntoff_ms = 2\n"),
            "4:1 JOB_VALUE: operation cut: power, or ton_ms and toff_ms, not both\n");
  EXPECT_EQ(wrong_in(operation + "ton_ms = 1\n"),
            "3:1 JOB_VALUE: operation cut: ton_ms and toff_ms are said together\n");
  EXPECT_EQ(wrong_in(operation + "feed = 5\nms_per_mm = 2\n"),
            "4:1 JOB_VALUE: operation cut: feed or ms_per_mm, not both\n");
  EXPECT_EQ(wrong_in(operation + "lead_in = {kind = 'arc'}\nlead_out = {kind = 'line'}\n"),
            "3:1 JOB_VALUE: operation cut: lead_in of an arc needs its radius\n"
            "4:1 JOB_VALUE: operation cut: lead_out of a line needs its length\n");
  EXPECT_EQ(wrong_in(operation + "tabs = {count = 2, spacing = 3}\n"),
            "3:1 JOB_VALUE: operation cut: tabs have count or spacing, not both\n");
  EXPECT_EQ(wrong_in(operation + "tabs = {width = 3}\n"),
            "3:1 JOB_VALUE: operation cut: tabs need count or spacing\n");
  EXPECT_EQ(wrong_in("[[operation]]\nprocess = 'weld'\nweave = {shape = 'sine', width = 1}\n"),
            "3:1 JOB_VALUE: operation weld: weave needs width and pitch\n");
  EXPECT_EQ(wrong_in("[[operation]]\nprocess = 'drill'\npulses = 3\n"),
            "3:1 JOB_VALUE: operation drill: pulses need ton_ms and toff_ms\n");
  EXPECT_EQ(wrong_in("[[operation]]\nprocess = 'raster'\ncurve = [[0, 0], [0, 1]]\n"),
            "3:1 JOB_VALUE: operation raster: curve has pairs from 0 to 1, the first of each "
            "ascending\n");
  EXPECT_EQ(wrong_in("[[operation]]\nname = 'a'\n[[operation]]\nname = 'a'\n"),
            "4:1 JOB_VALUE: operation a: another one has that name; --job-set could not tell them "
            "apart\n");
}

TEST(RecipeFile, tells_what_does_not_go_together_in_other_tables) {
  EXPECT_EQ(wrong_in("place = {scale = 2, fit = [3, 4]}\n"),
            "1:21 JOB_VALUE: [place] has scale or fit: fit says how large it becomes\n");
  EXPECT_EQ(wrong_in("array = {columns = 2, count = 3}\n"),
            "1:23 JOB_VALUE: [array] has columns and rows, or count\n");
  EXPECT_EQ(wrong_in("\narray = {columns = 1000, rows = 1000}\n"),
            "2:1 JOB_VALUE: [array] makes 1000000 copies; 100000 are the most\n");
  EXPECT_EQ(wrong_in("image = {width = 2, dpi = 3}\n"),
            "1:21 JOB_VALUE: [image] has width and height, or dpi\n");
  EXPECT_EQ(wrong_in("wrap = {shape = 'sphere'}\n"), "1:1 JOB_VALUE: [wrap] needs its radius\n");
  EXPECT_EQ(wrong_in("[[text.line]]\nat = [1, 2]\n"),
            "1:1 JOB_VALUE: [[text.line]] needs its text\n");
}

TEST(RecipeFile, tells_all_at_once_in_the_order_of_lines_and_at_most_a_hundred) {
  EXPECT_EQ(wrong_in("[place]\nb = 1\n[job]\na = 1\n[array]\ncolumns = 0\n"),
            "2:1 JOB_KEY: [place] has no key b\n4:1 JOB_KEY: [job] has no key a\n"
            "6:11 JOB_VALUE: columns is a whole number from 1 to 10000, not 0\n");
  std::string many = "[job]\n";
  for (int i = 0; i < 500; ++i) many += "k" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(read_recipe(many, "-", kFile).error().size(), 100U);
}

TEST(RecipeFile, the_line_of_a_finding_begins_where_it_says) {
  const auto read = read_recipe("# a\n[job]\nfoo = 1\n", "-", kFile);
  EXPECT_EQ(read.error().at(0).place.line_start, 10U);
}

}  // namespace
}  // namespace kerf::process
