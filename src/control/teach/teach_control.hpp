#pragma once

#include "control/core/record_control.hpp"
#include "control/teach/taught_moves.hpp"
#include "lang/teach/teach_library.hpp"

namespace kerf::control {

/// The control of a machine that goes to taught points: executes the records of a .tch file, one
/// block each, as TaughtMoves says. Points are where the machine was.
class TeachControl final : public RecordControl {
 public:
  /// All must outlive the control.
  TeachControl(const motion::AxisSetup& axes, const TaughtFor& machine,
               teach::TeachLibrary& library, Surroundings& surroundings, motion::MotionSink& sink);

  /// Stands at the head of the library's program, which has been loaded. `name` is what alarms call
  /// it.
  void start(std::string name);

  // Control
  void reset() override;
  [[nodiscard]] base::MachinePoint machine_position() const override {
    return base::MachinePoint(moves_.tip().numbers());
  }
  void stand_at(const base::TipPoint& tip) override { moves_.stand_at(tip); }
  [[nodiscard]] bool can_be_moved() const override { return true; }

 private:
  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  vm::Verdict end_of_code() override;

  // ProgramControl
  void undo_block() override { outlet_.reset(); }

  bool checks_strokes_;
  StrokeLimits strokes_;
  Outlet outlet_;
  TaughtMoves moves_;
};

}  // namespace kerf::control
