#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <vector>

#include "lang/gcode/page.hpp"

namespace kerf::gcode {

struct LoopEnding {
  vm::Region::State state = vm::Region::State::unresolved;
  vm::Address end;
};

/// Finds the END of each DO while the marks of a program pass once, in the order of the text: each
/// mark costs the same, however deep loops stand in each other.
///
/// The END of a DO is the next one of its number (CTL-13). The loop crosses another one when the
/// END of a DO that stands before it comes first (CTL-15).
class LoopMatcher {
 public:
  /// Where the marks begin: at the head of the program, or within it. Without the head, an answer
  /// that depends on what stands before is `unresolved`.
  enum class From : std::uint8_t { head, middle };
  /// Gets each DO that was asked for, by page and region, with what became of it.
  using Settle = std::function<void(vm::Address head, const LoopEnding& ending)>;

  LoopMatcher(From from, Settle settle) : from_(from), settle_(std::move(settle)) {}

  /// A DO whose END is asked for, or, with `asked` false, one that is only in the way of others.
  void take_do(std::uint8_t slot, vm::Address head, bool asked = true);
  void take_end(std::uint8_t slot, vm::Address end);
  /// No mark follows. `state` is that of each DO that still waits: `open` behind the end of the
  /// program, otherwise `unresolved`.
  void finish(vm::Region::State state);

 private:
  using Slots = std::bitset<vm::kRegionSlots>;
  struct Waiting {
    std::uint64_t order = 0;  // of its mark, counted from 1
    vm::Address head;
  };
  using Queue = std::vector<Waiting>;  // in the order of the text
  enum class Mark : std::uint8_t { none, head, end };
  struct Newest {
    Mark mark = Mark::none;
    std::uint64_t order = 0;
  };

  void settle_behind(Queue& queue, std::uint64_t order, const LoopEnding& ending);
  void settle_others(std::uint8_t slot);

  From from_;
  Settle settle_;
  std::uint64_t order_ = 0;
  std::array<Newest, vm::kRegionSlots> newest_{};  // mark of each slot
  // By slot, and by the slots that were open where the DO stands.
  std::array<std::array<Queue, 1U << vm::kRegionSlots>, vm::kRegionSlots> waiting_;
};

}  // namespace kerf::gcode
