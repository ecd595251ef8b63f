// Motions that no program stands behind, written as G-code of every flavour.
#include "output/programs/post_writer.hpp"

#include <gtest/gtest.h>

#include <string>

#include "temporary_folder.hpp"

namespace kerf::test {
namespace {

using namespace motion;
using output::PostFlavour;

Motion of_line(std::uint32_t line, Motion::Action action) {
  Motion motion{.action = std::move(action)};
  motion.block.line = line;
  return motion;
}

struct Written {
  std::string text;
  std::string json;
  std::uint64_t lost = 0;
};

// A contour with air, at a frequency of its own.
Written written(const PostFlavour& flavour) {
  const auto laser = *machine::find_machine("laser3");
  const TemporaryFolder folder;
  auto file = base::OutputFile::create(folder / "out");
  const auto post = output::make_post(laser, "plate.dxf", **file, {flavour});
  post->take(of_line(9, Coolant{Coolant::State::flood}));
  post->take(of_line(9, Rapid{{{10, 5, 0}}, true}));
  post->comment("outline, layer CUT, LWPOLYLINE", 9);
  post->frequency(5000, 9);
  post->take(of_line(9, Power{80}));
  post->take(of_line(9, Line{{{30, 5, 0}}, {900}}));
  post->take(of_line(9, Power{0}));
  post->take(of_line(9, Coolant{Coolant::State::off}));
  post->take(of_line(0, End{}));
  post->finish();
  EXPECT_TRUE((*file)->commit());
  return {folder.read("out"), post->json(), post->lost()};
}

std::string path_of(const std::string& text) { return text.substr(text.find("G21")); }

TEST(PostOfAPlan, HasItsCommentsAirAndBeam) {
  EXPECT_EQ(path_of(written(*output::find_flavour("grbl")).text),
            "G21 G90 G94 G17 G40 G49\nM5\nM8\nG0 Z0.\nG0 X10. Y5.\n"
            "(LINE 9: OUTLINE, LAYER CUT, LWPOLYLINE)\n(LINE 9: LASER FREQUENCY 5000 HZ)\n"
            "M3 S800\nG1 X30. F900.\nM5\nM9\nM5 M9 M2\n");
}

TEST(PostOfAPlan, TellsWhatNoFlavourHasAWordFor) {
  for (const PostFlavour& flavour : output::post_flavours()) {
    const Written plan = written(flavour);
    EXPECT_EQ(plan.lost, 1U) << flavour.name;
    EXPECT_EQ(plan.json, R"({"lost":[{"what":"frequency","count":1,"line":9}]})") << flavour.name;
    EXPECT_NE(plan.text.find("(LOST: FREQUENCY, 1X, FIRST OF LINE 9)"), std::string::npos);
  }
}

TEST(PostOfAPlan, IsRefusedWhereNoControlOfTheFlavourTurns) {
  const auto lathe = *machine::find_machine("lathe2");
  const TemporaryFolder folder;
  auto file = base::OutputFile::create(folder / "out");
  for (const PostFlavour& flavour : output::post_flavours()) {
    const bool turns = flavour.name == "plain" || flavour.name == "fanuc";
    EXPECT_EQ(output::make_post(lathe, "part", **file, {flavour}) != nullptr, turns)
        << flavour.name;
  }
}

}  // namespace
}  // namespace kerf::test
