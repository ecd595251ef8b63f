#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "control/control.hpp"
#include "machine/breakpoint.hpp"
#include "machine/condition.hpp"

namespace kerf::machine {

class Dialect;

/// How far a step goes.
enum class Step : std::uint8_t {
  over,  ///< to the next block of this program, or of its caller
  into,  ///< to the next block, wherever it is
  out    ///< to the next block of the caller
};

/// Decides before each block whether the program goes on (docs/stepping.md): breakpoints, steps,
/// run to line. It is asked only while it has something to look for: a program without breakpoints
/// runs as fast as without a stepper.
class Stepper : public control::BlockGate {
 public:
  /// Must outlive the stepper, or be replaced by watch().
  explicit Stepper(Dialect& dialect) : dialect_(&dialect) {}

  /// The same breakpoints for a machine made anew.
  void watch(Dialect& dialect);

  /// All breakpoints there are. Failure (usage): a condition is none in the language, a variable is
  /// none of the program; the sentence names the breakpoint. Then nothing has changed.
  [[nodiscard]] base::Outcome<void> set_breakpoints(std::vector<Breakpoint> breakpoints);
  [[nodiscard]] const std::vector<Breakpoint>& breakpoints() const { return breakpoints_; }

  // What stops the program besides: one of these at a time.

  /// From where it stands.
  void step(Step how);
  /// Before a line is executed the next time.
  void run_to(std::string file, std::uint32_t line);
  /// Before the block of this number, counted by blocks().
  void run_to_block(std::uint64_t number);
  void forget_target();

  /// Counts blocks even though nothing is looked for.
  void count_blocks(bool on);
  /// Blocks that have begun while it was asked, since the start.
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }

  /// What it has stopped the program for; nothing: for a step.
  [[nodiscard]] const std::optional<BreakpointHit>& hit() const { return hit_; }

  /// A program starts: no target, no values remembered.
  void start();
  /// The block that it has stopped before is executed now.
  void go_on();
  /// A variable was set by the operator.
  void forget_values() { known_.clear(); }

  // control::BlockGate
  [[nodiscard]] bool passes(const control::BlockStart& block) override;

 private:
  enum class Target : std::uint8_t { none, depth, line, block };
  struct Armed;

  void learn_gate();
  [[nodiscard]] bool reached(const control::BlockStart& block) const;
  [[nodiscard]] bool at_line_breakpoint(const control::BlockStart& block);
  [[nodiscard]] bool has_changed(const control::BlockStart& block);
  [[nodiscard]] bool is_file(const std::string& wanted, base::FileId file) const;

  Dialect* dialect_;
  std::vector<Breakpoint> breakpoints_;
  std::vector<Condition> conditions_;  // one a breakpoint; empty where it has none
  Target target_ = Target::none;
  std::size_t most_depth_ = 0;
  std::string file_;
  std::uint32_t line_ = 0;
  std::uint64_t block_ = 0;
  std::uint64_t blocks_ = 0;
  bool counts_ = false;
  bool leaves_stop_ = false;  // the next block is the one that it has stopped before
  std::uint32_t last_line_ = 0;
  std::optional<BreakpointHit> hit_;
  std::vector<std::vector<double>> known_;  // a variable's values, by the depth of calls
};

}  // namespace kerf::machine
