#pragma once

#include "control/core/alarms.hpp"
#include "control/core/assumptions.hpp"
#include "control/core/call_paths.hpp"
#include "control/core/control.hpp"
#include "lang/vm/host.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// What all controls share whose programs run in the virtual machine: alarm, halt, who is asked
/// before a block, where the program stands.
class ProgramControl : public Control, public vm::Host, protected Whereabouts {
 public:
  // Control
  [[nodiscard]] Halt halt() const override { return halt_; }
  [[nodiscard]] const std::optional<base::Diagnostic>& alarm() const override {
    return alarms_.alarm();
  }
  [[nodiscard]] const Assumptions& assumptions() const override { return assumptions_; }
  [[nodiscard]] std::uint64_t blocks() const override { return blocks_; }
  [[nodiscard]] base::Place standing_at() override { return place(); }
  [[nodiscard]] std::string running_program() const override { return program_name(); }
  [[nodiscard]] std::vector<OpenCall> open_calls() override;
  [[nodiscard]] std::vector<base::BlockId> calls(base::CallPath path) const override {
    return paths_.calls(path);
  }
  [[nodiscard]] std::uint64_t slashes() override;
  [[nodiscard]] std::uint64_t interrupts_missed() const override { return interrupts_missed_; }
  void miss_interrupt() override;
  void set_single_block(bool on) override;
  void observe_blocks(BlockObserver observer) override;
  void set_gate(BlockGate* gate) override;
  void allow_passing() override { may_pass_ = true; }
  [[nodiscard]] bool pass_alarm() override;

  // vm::Host
  void failure(const base::Diagnostic& diagnostic) override { alarms_.report(diagnostic); }
  /// Tells whoever asked. Anything but go_on: the control has halted.
  vm::Verdict begin_block(const vm::CodePage& page, const vm::BlockMark& mark) override;

  /// Open programs and subroutines; 0 before the start.
  [[nodiscard]] std::size_t levels();
  /// Registers of the program's local variables at a level, 0: main. Precondition: it is open.
  [[nodiscard]] std::span<double> locals_of(std::size_t level);

  /// Notes what was found in the program's text, outside of what the control sees of it.
  void assume(std::uint32_t key, std::uint32_t line, const std::string& what) {
    if (assumptions_.is_new(key)) assumptions_.add(line, what);
  }

 protected:
  ProgramControl() : alarms_(*this) {}

  /// Null before the first start.
  [[nodiscard]] virtual vm::Interpreter* interpreter() = 0;
  /// The name of the program at a level, 0: main.
  [[nodiscard]] virtual std::string name_of_level(std::size_t level) const = 0;
  /// The O number of that program; 0 in languages that have none.
  [[nodiscard]] virtual base::ProgramNumber number_of_level(std::size_t /*level*/) const {
    return {};
  }
  /// Whether single block stops where a block begins, and not where one ends.
  [[nodiscard]] virtual bool single_block_traces() const = 0;
  /// What the block has changed that raised an alarm and is left out.
  virtual void undo_block() = 0;

  // Whereabouts
  base::Place place() override;
  base::BlockId block() override;

  /// What runs: its program, and the calls that led to it.
  struct Running {
    base::ProgramNumber program;
    base::CallPath calls;
  };
  [[nodiscard]] Running running();
  /// The block with both.
  [[nodiscard]] static base::BlockId run_by(const Running& running, base::BlockId block) {
    block.program = running.program;
    block.calls = running.calls;
    return block;
  }

  /// The interpreter tells of blocks only where somebody asks.
  void learn_tracing();
  vm::Verdict halt_with(Halt halt, vm::Verdict verdict) {
    halt_ = halt;
    return verdict;
  }

  Alarms alarms_;
  Assumptions assumptions_;
  Halt halt_ = Halt::none;
  std::uint64_t blocks_ = 0;
  bool single_block_ = false;
  bool in_statement_ = false;  // a statement has begun that single block stops behind
  bool may_pass_ = false;      // allow_passing()

 private:
  // A call that is open, and the path behind it.
  struct CallUnderWay {
    std::uint64_t number = 0;
    base::CallPath path{};
  };
  [[nodiscard]] base::CallPath path_to(std::size_t level);
  [[nodiscard]] base::BlockId caller(std::size_t level);

  CallPaths paths_;
  std::vector<CallUnderWay> under_way_;  // of level n the entry n - 1
  BlockObserver observer_;
  BlockGate* gate_ = nullptr;
  std::uint64_t interrupts_missed_ = 0;
};

}  // namespace kerf::control
