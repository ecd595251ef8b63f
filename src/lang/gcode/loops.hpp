#pragma once

#include <cstdint>
#include <span>

#include "lang/gcode/page.hpp"

namespace kerf::gcode {

/// A DO or END and the page that it stands on.
struct PlacedLoopMark {
  LoopMark mark;
  std::uint32_t page = 0;
};

struct LoopEnding {
  vm::Region::State state = vm::Region::State::unresolved;
  vm::Address end;
};

/// The END that belongs to the DO `marks[index]`: the next one of its number (CTL-13). The loop
/// crosses another one when the END of a DO that stands before it comes first (CTL-15). `marks` are
/// in the order of the text; `from_head` and `complete` say that the program begins and ends with
/// them: without, an answer that depends on what lies outside is `unresolved`.
[[nodiscard]] LoopEnding find_end(std::span<const PlacedLoopMark> marks, std::size_t index,
                                  bool from_head, bool complete);

}  // namespace kerf::gcode
