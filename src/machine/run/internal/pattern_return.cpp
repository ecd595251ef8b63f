#include "machine/run/internal/pattern_return.hpp"

#include "drive/pattern/split.hpp"
#include "machine/dialect/pattern_motors.hpp"

namespace kerf::machine {

void each_move_of_return(
    const PatternMachine& machine, const base::JointPoint& joints,
    const std::function<void(const QueuedRecord&, const motion::Motion&)>& take) {
  const drive::ArmCounts from = machine.counts_at(joints);
  CountedOnly counted;
  PatternMotors motors(machine, counted, from);
  for (const drive::FastMove& move : machine.way_to_start(from)) {
    drive::each_record(move, [&](const drive::FastRecord& record) {
      const drive::ArmCounts before = motors.counters();
      static_cast<void>(motors.make(record));  // only cuts are too much for a timer
      if (motors.motion()) take({record, before, true}, *motors.motion());
    });
  }
}

}  // namespace kerf::machine
