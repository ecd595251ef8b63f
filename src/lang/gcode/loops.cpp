#include "lang/gcode/loops.hpp"

#include <array>

namespace kerf::gcode {

using State = vm::Region::State;

LoopEnding find_end(std::span<const PlacedLoopMark> marks, std::size_t index, bool complete) {
  const std::uint8_t slot = marks[index].mark.slot;
  std::array<bool, vm::kRegionSlots> open_inside{};
  for (std::size_t i = index + 1; i < marks.size(); ++i) {
    const LoopMark& mark = marks[i].mark;
    if (!mark.is_end) {
      open_inside[mark.slot] = mark.slot != slot;
    } else if (mark.slot != slot) {
      open_inside[mark.slot] = false;
    } else {
      for (const bool open : open_inside) {
        if (open) return {State::crossing, {}};
      }
      return {State::closed, {marks[i].page, mark.index}};
    }
  }
  return {complete ? State::open : State::unresolved, {}};
}

}  // namespace kerf::gcode
