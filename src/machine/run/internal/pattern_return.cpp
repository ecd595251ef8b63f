// Back to where a pattern begins. The motors go one by one, by counting: a straight way of the tip
// may not be possible, above all where the arm is stretched.
#include "drive/pattern/split.hpp"
#include "machine/dialect/pattern_motors.hpp"
#include "machine/run/virtual_machine.hpp"

namespace kerf::machine {

bool VirtualMachine::command_way_to_start() {
  const PatternMachine machine = *PatternMachine::of(definition_);
  const drive::ArmCounts from = machine.counts_at(servo_.joints());
  CountedOnly counted;
  PatternMotors motors(machine, counted, from);
  for (const drive::FastMove& move : machine.way_to_start(from)) {
    drive::each_record(move, [&](const drive::FastRecord& record) {
      const drive::ArmCounts before = motors.counters();
      static_cast<void>(motors.make(record));  // only cuts are too much for a timer
      if (!motors.motion()) return;
      records_.push_back({record, before, true});
      make(*motors.motion());
      is_active_ = is_by_hand_ = true;
    });
  }
  servo_.finish();
  return is_active_;
}

}  // namespace kerf::machine
