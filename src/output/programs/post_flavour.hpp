#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace kerf::output {

/// The G-code that a posted program is written in, as data: what controls of one kind take and what
/// they do not (docs/command-line.md, "Flavours").
struct PostFlavour {
  /// Where the length of a tool goes.
  enum class Lengths : std::uint8_t {
    added,    ///< to the coordinates
    dynamic,  ///< G43.1, as much longer as the tool is than the first one
    of_table  ///< G43 with H: the control's table has it
  };
  enum class Dwell : std::uint8_t { seconds, milliseconds };

  std::string_view name;
  std::string_view controls;     ///< for whom the program is, in its head
  std::string_view modes;        ///< first block behind the head
  std::string_view lathe_modes;  ///< likewise of a lathe; empty: no such control turns
  std::string_view end;          ///< last block; spindle and beam are off before
  Lengths lengths = Lengths::added;
  Dwell dwell = Dwell::seconds;
  bool is_framed = false;          ///< percent signs, and an O number with the name
  bool has_tolerance = false;      ///< G64 P, G61 where corners are exact
  bool has_two_digits = false;     ///< G01, M03
  bool changes_tools = true;       ///< T and M6; else M0 for somebody who does
  bool length_with_move = false;   ///< G43 stands in the block that moves Z
  bool has_following_beam = true;  ///< M4: power that follows the speed
  bool has_rotary_axes = true;     ///< else they are written where they are named
};

/// plain, grbl, linuxcnc, fanuc: the first one is what is written where none is named.
[[nodiscard]] std::span<const PostFlavour> post_flavours();
/// Null: there is none of that name.
[[nodiscard]] const PostFlavour* find_flavour(std::string_view name);

}  // namespace kerf::output
