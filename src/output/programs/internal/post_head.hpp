#pragma once

#include <optional>
#include <string>

#include "machine/definition/machine_definition.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion_extent.hpp"
#include "output/programs/internal/lost_things.hpp"
#include "output/programs/post_flavour.hpp"

namespace kerf::output {

/// What a posted program is, known when all of it is made.
struct PostFacts {
  std::string program;  ///< as people call it
  const machine::MachineDefinition& machine;
  const PostFlavour& flavour;
  std::optional<motion::MotionExtent> travel;  ///< nothing: nothing moves
  bool has_lengths = false;                    ///< tool lengths are in force
  const LostThings& lost;
};

/// Comments for who sends the program to a machine, then the blocks before its first one: units,
/// planes and modes, and no beam or spindle (M5).
[[nodiscard]] std::string post_head(const PostFacts& facts);

/// Where the path begins, as coordinates are written.
struct Beginning {
  const motion::AxisSetup& axes;
  const PostFlavour& flavour;
  base::AxisSet said;  ///< axes that are written
  base::TipPoint first;
  double level_mm = 0;         ///< of Z
  std::string length_words{};  ///< that bring the tool's length
};

/// Rapids that bring every axis there from wherever the machine stands: Z alone to the level, the
/// other axes, rotary ones first, then Z to where it begins.
[[nodiscard]] std::string positioning(const Beginning& beginning);

/// Of a lathe likewise.
[[nodiscard]] std::string lathe_head(const PostFacts& facts);

/// Rapids to `corner` from wherever a lathe stands: X alone, outwards, then each of the others.
[[nodiscard]] std::string lathe_positioning(const motion::AxisSetup& axes,
                                            const PostFlavour& flavour,
                                            const base::TipPoint& corner);

}  // namespace kerf::output
