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

/// The END that belongs to the DO `marks[index]`: the next one of its number (CTL-13). A loop inside
/// of it that ends behind it crosses it (CTL-15). `marks` are in the order of the text; `complete`
/// says that the program ends with them: without it an END that is missing may still follow.
[[nodiscard]] LoopEnding find_end(std::span<const PlacedLoopMark> marks, std::size_t index, bool complete);

}  // namespace kerf::gcode
