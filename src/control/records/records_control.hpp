#pragma once

#include <array>
#include <string>
#include <vector>

#include "control/core/memory.hpp"
#include "control/core/outlet.hpp"
#include "control/core/record_control.hpp"
#include "lang/records/records_library.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::control {

/// What motion records are held against.
struct RecordedFor {
  bool checks_strokes = false;                       ///< parameter stroke_check
  std::array<double, motion::kSpindles> most_rpm{};  ///< of each spindle; 0: not known
};

/// The control of a machine that makes the motions of a file as they stand there, each with the
/// block that it comes from. A record that goes nowhere is no motion. Alarms are told at the record
/// itself: MJ0004, ARC_COLLINEAR, ARC_COINCIDENT, and what the machine refuses.
class RecordsControl final : public RecordControl {
 public:
  /// All must outlive the control.
  RecordsControl(const motion::AxisSetup& axes, const RecordedFor& machine,
                 records::RecordsLibrary& library, Memory& memory, Surroundings& surroundings,
                 motion::MotionSink& sink);

  /// Stands at the head of the library's program, which has been loaded. `name` is what alarms call
  /// it.
  void start(std::string name);

  // Control
  void reset() override;
  [[nodiscard]] base::MachinePoint machine_position() const override {
    return base::machine_of(tip_, length_);
  }
  [[nodiscard]] base::AxisVector tool_length() const override { return length_; }
  void stand_at(const base::TipPoint& tip) override { tip_ = tip; }
  [[nodiscard]] bool can_be_moved() const override { return true; }
  void set_optional_stop(bool on) override { optional_stop_ = on; }

 private:
  /// How many unknown members are told.
  static constexpr std::size_t kMostUnknown = 20;

  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  vm::Verdict end_of_code() override { return halt_with(Halt::end, vm::Verdict::stop); }

  // ProgramControl
  void undo_block() override { outlet_.reset(); }

  void tell(const std::string& unknown);
  void put_on(const motion::ToolLength& length);
  void set(const records::ToolRadius& radius);
  [[nodiscard]] bool is_made(const records::RecordBlock& record);
  [[nodiscard]] bool is_arc(const motion::Arc& arc, const records::RecordBlock& record);
  [[nodiscard]] bool is_arc(const motion::SpaceArc& arc);
  [[nodiscard]] bool is_arc(const motion::SurfaceMove& move);
  [[nodiscard]] bool is_thread(const motion::Thread& thread);
  [[nodiscard]] bool goes_nowhere(const motion::Motion& motion) const;
  [[nodiscard]] motion::Motion as_made(const records::RecordBlock& record);
  vm::Verdict behind(const motion::Motion& motion);

  const motion::AxisSetup& axes_;
  RecordedFor machine_;
  Memory& memory_;
  base::AxisVector length_;
  StrokeLimits strokes_;
  Outlet outlet_;
  base::TipPoint tip_;
  motion::ToolLength tool_length_;  // of the moves to come
  bool optional_stop_ = false;
  std::vector<std::string> unknown_;  // told
};

}  // namespace kerf::control
