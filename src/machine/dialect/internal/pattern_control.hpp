#pragma once

#include <string>

#include "control/core/record_control.hpp"
#include "machine/dialect/internal/pattern_library.hpp"
#include "machine/dialect/pattern_motors.hpp"
#include "machine/dialect/pattern_queue.hpp"

namespace kerf::machine {

/// The control of a machine that makes patterns: each line of the listing is a block, its records
/// are pulses counted from where every counter is 0.
///
/// A record that would take a joint beyond its travel is the alarm LIMIT, one that the timers
/// cannot make TIMER_OVERFLOW, and nothing of it is handed out.
class PatternControl final : public control::RecordControl {
 public:
  /// All must outlive the control. `records` gets the record of each motion that `sink` gets.
  PatternControl(const PatternMachine& machine, PatternLibrary& library, PatternQueue& records,
                 motion::MotionSink& sink);

  /// Stands at the head of the library's program, which has been loaded, with every counter at 0.
  /// `name` is what alarms call it.
  void start(std::string name);

  // Control
  control::Halt run(std::uint64_t instructions) override;
  void reset() override;
  [[nodiscard]] base::MachinePoint machine_position() const override {
    return base::MachinePoint(motors_.tip().numbers());
  }
  /// The records behind it count from where the last one has ended.
  void stand_at(const base::TipPoint& /*tip*/) override {}
  [[nodiscard]] bool can_be_moved() const override { return !is_open_; }

 private:
  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  vm::Verdict end_of_code() override;

  // ProgramControl
  void undo_block() override {}

  bool command(const drive::PatternRecord& record, bool ends_block);
  bool refuse(const PatternMotors& before, base::Diagnostic alarm);
  void hand_out(motion::Motion motion);

  const PatternMachine& machine_;
  PatternQueue& records_;
  CountedOnly counted_;
  PatternMotors motors_;  // as the program has them
  bool is_open_ = false;
};

}  // namespace kerf::machine
