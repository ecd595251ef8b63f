#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "control/core/control.hpp"
#include "machine/dialect/condition.hpp"
#include "machine/run/breakpoint.hpp"

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

  /// The same breakpoints for another machine; the one that was watched is not asked any more.
  void watch(Dialect& dialect);
  /// Likewise, where that one is gone.
  void attach(Dialect& dialect);

  /// All breakpoints there are. Failure (usage): a condition is none in the language, a variable is
  /// none of the program; the sentence names the breakpoint. Then nothing has changed.
  [[nodiscard]] base::Outcome<void> set_breakpoints(std::vector<Breakpoint> breakpoints);
  [[nodiscard]] const std::vector<Breakpoint>& breakpoints() const { return breakpoints_; }

  // What stops the program besides: one of these at a time.

  /// From where it stands.
  void step(Step how);
  /// Before a line is executed the next time.
  void run_to(std::string file, std::uint32_t line);
  // These stay, whatever else the program stops for, until they are set anew; 0: off. Nothing else
  // stops it before.

  /// Before a line of the loaded program.
  void search_line(std::uint32_t line);
  /// Before the block of this number, counted from 1, and no breakpoint between.
  void search_block(std::uint64_t number);
  void forget_target();

  /// Counts blocks even though nothing is looked for.
  void count_blocks(bool on);
  /// Blocks that have begun while it was asked, since the machine was made: entries in MDI count
  /// on.
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  /// Does something before the block of this number, and lets it pass.
  void before_block(std::uint64_t number, std::function<void()> act);
  void forget_acts();

  /// What it has stopped the program for; nothing: for a step.
  [[nodiscard]] const std::optional<BreakpointHit>& hit() const { return hit_; }

  /// A program starts: no target, no values remembered.
  void start();
  /// The block that it has stopped before is executed now.
  void go_on();
  /// A variable was set by the operator: that stops nothing.
  void forget_values() { remember(depth_); }

  // control::BlockGate
  [[nodiscard]] bool passes(const control::BlockStart& block) override;

 private:
  enum class Target : std::uint8_t { none, depth, line };

  [[nodiscard]] base::Outcome<std::vector<Condition>> compile(
      const std::vector<Breakpoint>& breakpoints);
  void learn_gate();
  void act_before(std::uint64_t number);
  void remember(std::size_t depth);
  [[nodiscard]] std::size_t depth_of(std::size_t number, std::size_t depth) const;
  [[nodiscard]] bool is_met(std::size_t number, BreakpointHit hit);
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
  std::uint32_t searched_line_ = 0;
  std::uint64_t searched_block_ = 0;
  std::uint64_t blocks_ = 0;
  std::multimap<std::uint64_t, std::function<void()>> acts_;  // by the number of a block to come
  bool counts_ = false;
  std::uint32_t last_line_ = 0;
  std::size_t depth_ = 1;  // of calls, at the block that it was asked for last
  std::optional<BreakpointHit> hit_;
  std::vector<std::vector<double>> known_;  // a variable's values, by the depth of calls
};

}  // namespace kerf::machine
