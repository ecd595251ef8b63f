#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lang/vm/code_page.hpp"
#include "lang/vm/host.hpp"

namespace kerf::vm {

/// Runs compiled programs. It knows numbers, jumps, calls and "do this block"; what a block means
/// is the host's business, what null, a label or a function means was settled by the front end.
///
/// Registers: every frame has a window of kRegisters; the first `locals` are its local variables. A
/// shared call gets the window of its caller, a fresh one a new window with all locals null.
class Interpreter {
 public:
  struct Settings {
    std::uint32_t locals = 0;   ///< local variables per level, < kRegisters
    std::span<double> globals;  ///< storage of the global variables, owned by the caller
    const void* builtin_rules = nullptr;
    // Of languages that count their loops, calls and steps by instructions:
    std::size_t most_loops = 256;  ///< counted loops open at once
    std::size_t most_calls = 1024;
    std::uint64_t steps = ~std::uint64_t{0};  ///< that a program may make
  };

  enum class Stop : std::uint8_t {
    budget,  ///< the allowed number of instructions was used up; resumable
    paused,  ///< the host said so; resumable
    over     ///< the program is over
  };

  Interpreter(CodeSource& source, Host& host, const Settings& settings);

  /// Forgets all frames and stands at the head of `main` with all locals null.
  void start(CodeId main);

  /// Runs at most about `instructions` instructions.
  Stop run(std::uint64_t instructions);

  // For the host, during one of its calls, and for whoever runs the interpreter between two runs.

  enum class Locals : std::uint8_t { fresh, shared };

  /// Goes to the head of `code`; return_to_caller() comes back behind the block that is executing.
  void call(CodeId code, Locals locals);
  /// Leaves the running frame. Not in the first one.
  void return_to_caller();
  /// Goes to the head of the running frame's code again; its registers stay.
  void restart();
  void jump(Address target);
  /// Behind a run that was over: goes to the block behind the one that executed, unless that has
  /// gone elsewhere itself. False: nothing follows it.
  [[nodiscard]] bool leave_block();
  /// Goes to a label of the running frame's code, searched from the executing block. False:
  /// missing.
  [[nodiscard]] bool jump_to_label(std::uint32_t label);

  [[nodiscard]] std::span<double> locals();
  [[nodiscard]] std::span<double> locals_of_first_level() {
    return {registers_.data(), settings_.locals};
  }
  /// Of frame `depth`, 0 to depth() - 1, counted from the first.
  [[nodiscard]] std::span<double> locals_of(std::size_t depth) {
    return std::span(registers_).subspan(frames_[depth].base, settings_.locals);
  }
  [[nodiscard]] std::size_t depth() const { return frames_.size(); }
  [[nodiscard]] CodeId running_code() const { return frames_.back().code; }
  /// The text of the instruction that executes, or executed last. What has no text of its own, as
  /// the end of the program, stands where the block before it does.
  [[nodiscard]] base::Place place();
  /// The instruction that executes, in running_code().
  [[nodiscard]] Address running() const { return running_.at; }
  /// The text of the call in frame `depth`, 1 to depth() - 1, counted from the first.
  [[nodiscard]] base::Place place_of_call(std::size_t depth);
  /// The block that executes, or executed last. Program and calls are not the interpreter's
  /// business.
  [[nodiscard]] base::BlockId block();
  /// The one that made such a call. Asks for no page: the one that is executed stays valid.
  [[nodiscard]] const base::BlockId& block_of_call(std::size_t depth) const {
    return frames_[depth].by;
  }
  /// Tells the calls that opened a frame apart: another one, another number.
  [[nodiscard]] std::uint64_t call_number(std::size_t depth) const { return frames_[depth].call; }
  /// The newest `note` of the program.
  [[nodiscard]] std::uint32_t note() const { return note_; }

  void set_switches(std::uint32_t bits) { switches_ = bits; }
  /// How often it has looked at a switch.
  [[nodiscard]] std::uint64_t switches_read() const { return switches_read_; }
  void set_tracing(bool on) { tracing_ = on; }

 private:
  struct ActiveRegion {
    bool active = false;
    Address head;
    Address end;
  };
  struct Frame {
    CodeId code{};
    Address at{};  // the next instruction
    std::uint32_t base = 0;
    std::array<ActiveRegion, kRegionSlots> regions{};
    std::size_t first_loop = 0;   // its counted loops are those from here on
    std::size_t first_saved = 0;  // its saved variables
    std::uint64_t call = 0;       // counts all calls
    base::BlockId by{};           // the block that called
  };
  // The passes of a counted loop: first + k · step while nothing else has written its variable, so
  // that no rounding adds up.
  struct CountedLoop {
    std::uint32_t variable = 0;
    double first = 0;
    double last = 0;  // value that the last pass left behind
    double to = 0;
    double step = 0;
    double passes = 0;
    Address head;
  };
  struct SavedVariable {
    std::uint32_t variable = 0;
    double value = 0;
  };
  // The block that is one too many, known once it is near.
  struct StepsEnd {
    Address at;
    std::uint32_t column = 0;
  };
  struct Running {
    CodeId code{};
    Address at;
  };
  static constexpr CodeId kNoCode{~0U};
  struct CachedJump {
    CodeId code = kNoCode;
    Address from;
    std::uint32_t label = 0;
    Address to;
  };

  template <bool kTracing>
  struct Loop;
  template <bool kTracing>
  Stop run_loop(std::uint64_t instructions);
  void drop_left_regions(Address target);
  bool go_to_label(double label);
  bool enter_region(std::uint32_t number);
  bool leave_region(std::uint32_t number);
  bool repeat_region(std::uint8_t slot);
  [[nodiscard]] double& variable(std::uint32_t number);
  void discard_loop_of(std::uint32_t variable);
  bool open_loop(const Instruction& instruction, bool& has_pass);
  bool repeat_loop(std::uint32_t variable, bool& goes_on);
  bool call_label(std::uint32_t label);
  void save_variable(std::uint32_t number);
  void end_steps_behind(const CodePage& page, std::uint32_t count_steps);
  const Region* closed_region(std::uint32_t number);
  bool fail(Fault fault);

  CodeSource& source_;
  Host& host_;
  Settings settings_;
  std::vector<double> registers_;
  std::vector<Frame> frames_;
  std::vector<CountedLoop> loops_;
  std::vector<SavedVariable> saved_;
  std::uint64_t steps_left_ = 0;
  std::optional<StepsEnd> steps_end_;
  bool steps_spent_ = false;
  std::vector<CachedJump> jumps_;
  Running running_;               // the instruction that executes, for place()
  std::optional<Address> begun_;  // the block whose begin the host has already seen
  std::uint32_t switches_ = 0;
  std::uint64_t switches_read_ = 0;
  std::uint64_t calls_ = 0;
  std::uint32_t note_ = 0;
  bool tracing_ = false;
};

}  // namespace kerf::vm
