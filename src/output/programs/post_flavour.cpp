#include "output/programs/post_flavour.hpp"

#include <algorithm>
#include <array>

namespace kerf::output {
namespace {

using Lengths = PostFlavour::Lengths;
using DwellIn = PostFlavour::Dwell;

constexpr PostFlavour kPlain = {.name = "plain",
                                .controls = "CONTROLS OF PLAIN G-CODE: NO MACROS, NO CYCLES",
                                .modes = "G21 G90 G94 G17",
                                .lathe_modes = "G21 G18 G40 G97 G98",
                                .end = "M30"};

constexpr PostFlavour kGrbl = {.name = "grbl",
                               .controls = "GRBL 1.1",
                               .modes = "G21 G90 G94 G17 G40 G49",
                               .lathe_modes = {},
                               .end = "M5 M9 M2",
                               .lengths = Lengths::dynamic,
                               .dwell = DwellIn::seconds,
                               .changes_tools = false,
                               .has_rotary_axes = false};

constexpr PostFlavour kLinuxCnc = {.name = "linuxcnc",
                                   .controls = "LINUXCNC",
                                   .modes = "G21 G90 G94 G17 G40 G49 G80",
                                   .lathe_modes = {},
                                   .end = "M2",
                                   .lengths = Lengths::of_table,
                                   .has_tolerance = true,
                                   .has_following_beam = false};

constexpr PostFlavour kFanuc = {.name = "fanuc",
                                .controls = "FANUC",
                                .modes = "G21 G90 G94 G17 G40 G49 G80",
                                .lathe_modes = "G21 G18 G40 G80 G97 G98",
                                .end = "M30",
                                .lengths = Lengths::of_table,
                                .dwell = DwellIn::milliseconds,
                                .is_framed = true,
                                .has_two_digits = true,
                                .length_with_move = true,
                                .has_following_beam = false};

constexpr std::array kFlavours = {kPlain, kGrbl, kLinuxCnc, kFanuc};

}  // namespace

std::span<const PostFlavour> post_flavours() { return kFlavours; }

const PostFlavour* find_flavour(std::string_view name) {
  const auto* const found =
      std::find_if(kFlavours.begin(), kFlavours.end(),
                   [&](const PostFlavour& flavour) { return flavour.name == name; });
  return found == kFlavours.end() ? nullptr : found;
}

}  // namespace kerf::output
