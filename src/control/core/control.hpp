#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/interface.hpp"
#include "base/place.hpp"
#include "base/point.hpp"
#include "control/core/assumptions.hpp"
#include "control/core/cycle_counts.hpp"
#include "control/core/work_system.hpp"

namespace kerf::control {

/// Why the control has given up control.
enum class Halt : std::uint8_t {
  none,           ///< it can go on
  single_block,   ///< a block is over and single block is on
  program_stop,   ///< M00
  optional_stop,  ///< M01 with the switch on
  message,        ///< #3006
  gate,           ///< a BlockGate has not let the next block pass
  end,            ///< the program's end: M02, M30, END
  alarm
};

/// The modes of a control at one moment, as a plain value: what it means says the control whose it
/// is (Control::modal_text).
struct ModalView {
  std::array<std::uint16_t, 26> codes{};
  double feed = 0;
  double speed = 0;
  std::uint32_t further_system = 0;  ///< 1 to 300: G54.1 P; 0: one of the six
  std::uint32_t length_offset = 0;
  std::uint32_t radius_offset = 0;
  std::uint32_t tool_offset = 0;  ///< of a lathe: the one that T has brought
  friend bool operator==(const ModalView&, const ModalView&) = default;
};

/// A program or subroutine that is open.
struct OpenCall {
  std::string program;
  base::BlockId block;  ///< that executes there, or comes next; of a caller the one that called
};

/// A block that is to be executed next.
struct BlockStart {
  base::FileId file = base::kNoFile;
  std::uint32_t line = 0;      ///< from 1
  bool first_of_line = false;  ///< no block before it on its line
  std::size_t depth = 1;       ///< programs and subroutines that are open, this one included
};

/// Asked before every block.
class BlockGate : public base::Interface {
 public:
  /// False: the control halts before the block (Halt::gate). Run on, it executes the block without
  /// asking again.
  [[nodiscard]] virtual bool passes(const BlockStart& block) = 0;
};

/// A control as its machine sees it: executes a program of its language and emits what the machine
/// must do. How a program gets into it and is started is the matter of each.
class Control : public base::Interface {
 public:
  /// Called at the beginning of each block with its file and line.
  using BlockObserver = std::function<void(base::FileId file, std::uint32_t line)>;

  /// Runs on, at most about `instructions` steps, until something halts it, the receiver of the
  /// motions is not ready, or the budget is used up. Not after an end or an alarm.
  virtual Halt run(std::uint64_t instructions) = 0;
  /// The reset button: no alarm, modes as at power-on. The tool stays where it is.
  virtual void reset() = 0;

  [[nodiscard]] virtual Halt halt() const = 0;
  [[nodiscard]] virtual const std::optional<base::Diagnostic>& alarm() const = 0;
  /// What was accepted although it is probably a mistake: of each place and code the first one, and
  /// not more than kMostWarnings of them.
  [[nodiscard]] const std::vector<base::Diagnostic>& warnings() const { return warnings_; }
  static constexpr std::size_t kMostWarnings = 100;
  /// What was accepted and may surprise.
  [[nodiscard]] virtual const Assumptions& assumptions() const = 0;
  /// Cycles that turned; of other languages and machines none.
  [[nodiscard]] virtual const std::vector<CycleCount>& cycles() const;
  /// Blocks that were executed: of a language without blocks, statements that did something.
  [[nodiscard]] virtual std::uint64_t blocks() const = 0;

  /// Machine coordinates of all axes, tool length included.
  [[nodiscard]] virtual base::MachinePoint machine_position() const = 0;
  /// What of them is the tool's length.
  [[nodiscard]] virtual base::AxisVector tool_length() const = 0;
  /// The axes that the program has told to move since power-on: where the others stand, only the
  /// machine knows. Of a language that names no axes all.
  [[nodiscard]] virtual base::AxisSet commanded() const { return static_cast<base::AxisSet>(-1); }
  /// Of a language without work coordinate systems the first one.
  [[nodiscard]] virtual WorkSystem work_system() const { return {}; }
  /// Where the zero of the active work coordinate system lies.
  [[nodiscard]] virtual base::AxisVector work_origin() const = 0;

  /// The tool stands at `tip` (machine coordinates without tool length), where it was brought by
  /// hand. Precondition: can_be_moved().
  virtual void stand_at(const base::TipPoint& tip) = 0;
  /// Nothing that was commanded waits for the next block: cutter compensation, a corner.
  [[nodiscard]] virtual bool can_be_moved() const = 0;

  /// The text that is executing, or that comes next.
  [[nodiscard]] virtual base::Place standing_at() = 0;
  [[nodiscard]] virtual std::string running_program() const = 0;
  /// Main program first; empty before the start.
  [[nodiscard]] virtual std::vector<OpenCall> open_calls() = 0;
  /// The blocks whose calls led to a block of this run, the main program's first; none, where they
  /// were more than a run keeps.
  [[nodiscard]] virtual std::vector<base::BlockId> calls(base::CallPath path) const = 0;
  [[nodiscard]] virtual ModalView modal() const = 0;
  /// The list that this control shows, one entry a code or mode.
  [[nodiscard]] virtual std::vector<std::string> modal_text(const ModalView& modal) const = 0;

  virtual void set_single_block(bool on) = 0;
  virtual void set_optional_stop(bool on) = 0;
  /// One bit per level: bit n for /n, n = 1 to 9.
  virtual void set_block_skip(std::uint32_t levels) = 0;
  /// Slashes that the program has come to.
  [[nodiscard]] virtual std::uint64_t slashes() = 0;
  /// Slows down.
  virtual void observe_blocks(BlockObserver observer) = 0;
  /// Asked before every block; null: none. Slows down.
  virtual void set_gate(BlockGate* gate) = 0;
  /// The signal of a macro interrupt: answered before the next block that is executed, where the
  /// program allows it.
  virtual void interrupt() = 0;
  /// Of these signals those that met a program that did not allow them, and did nothing.
  [[nodiscard]] virtual std::uint64_t interrupts_missed() const = 0;
  /// Such a signal: it is told as an assumption.
  virtual void miss_interrupt() = 0;

  /// For a search for mistakes, never for a machine: from now on pass_alarm() may be asked. Slows
  /// down. Precondition: nothing has run.
  virtual void allow_passing() = 0;
  /// Behind an alarm: leaves out the block that raised it and stands behind it, with modes and
  /// position as they were before it; cutter compensation is over. False: nothing that could be
  /// run follows, as behind #3000, or where the program runs out. Precondition: allow_passing().
  [[nodiscard]] virtual bool pass_alarm() = 0;

 protected:
  /// Cheap where the same was said before.
  void warn(base::Code code, const base::Place& place, const std::string& detail,
            const std::string& program);
  void forget_warnings() { warnings_.clear(); }

 private:
  std::vector<base::Diagnostic> warnings_;
};

}  // namespace kerf::control
