#include "lang/gcode/loops.hpp"

#include <array>

namespace kerf::gcode {

using State = vm::Region::State;

LoopEnding find_end(std::span<const PlacedLoopMark> marks, std::size_t index, bool from_head,
                    bool complete) {
  const std::uint8_t slot = marks[index].mark.slot;
  std::array<bool, vm::kRegionSlots> open_around{};
  for (std::size_t i = 0; i < index; ++i) open_around[marks[i].mark.slot] = !marks[i].mark.is_end;
  std::array<bool, vm::kRegionSlots> open_inside{};
  for (std::size_t i = index + 1; i < marks.size(); ++i) {
    const LoopMark& mark = marks[i].mark;
    if (!mark.is_end) {
      open_inside[mark.slot] = true;
    } else if (mark.slot == slot) {
      return {State::closed, {marks[i].page, mark.index}};
    } else if (open_inside[mark.slot]) {
      open_inside[mark.slot] = false;
    } else if (open_around[mark.slot]) {
      return {State::crossing, {}};
    } else if (!from_head) {
      return {State::unresolved, {}};
    }
  }
  return {complete ? State::open : State::unresolved, {}};
}

}  // namespace kerf::gcode
