#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "machine/run/machine.hpp"

namespace kerf::machine {

/// A machine whose time passes by advance(). The servo makes points up to a time; when it has made
/// all that it can of what it has, the control executes blocks until the servo has no room for
/// more. So both do the same things in the same order as in a BatchRun, however time is cut.
class PacedRun : public Machine {
 public:
  PacedRun(const MachineDefinition& definition, control::Memory memory, const Settings& settings);

  /// Called before the control executes blocks while all that it has commanded is made.
  void observe_rest(std::function<void()> observer) { at_rest_ = std::move(observer); }
  /// Whether the line that INPUT waits for is there; without it all of them are.
  void set_input_ready(std::function<bool()> question) { input_ready_ = std::move(question); }
  using Machine::alter_motions;

  // Time

  /// How far a run has come, which does not depend on how time is cut.
  struct Moment {
    static constexpr std::uint64_t kAllTurns = ~std::uint64_t{0};
    std::uint64_t points = 0;  ///< that were handed out
    /// That the control had since the last of them; kAllTurns: the next point is made and waits.
    std::uint64_t turns = 0;
    bool operator==(const Moment&) const = default;
  };
  static constexpr Moment kNever{~std::uint64_t{0}, Moment::kAllTurns};
  [[nodiscard]] Moment moment() const;
  /// Makes set-points up to a time of the run, and executes blocks as far as the servo has room for
  /// what they command; not beyond `last`. True: the time is reached. False: the axes rest and
  /// nothing follows (!is_active()), or there was too much to compute for one call, or a line of
  /// input is missing.
  bool advance(double until_s, const Moment& last);
  /// Blocks or points are to come.
  [[nodiscard]] bool is_active() const { return is_active_; }
  /// The program has begun and is not over.
  [[nodiscard]] bool is_in_program() const { return is_in_program_; }
  /// The control has halted, whatever is still to be made.
  [[nodiscard]] bool has_halted() const { return !executes_; }
  [[nodiscard]] bool waits_for_input() const { return waits_for_input_; }

  // Programs

  /// Begins the program, or goes on behind a stop, as advance() has it. False: an alarm.
  bool set_off();
  /// Begins an entry in MDI. False: an alarm.
  bool set_off_entry(std::unique_ptr<base::SourceFile> file);
  /// The program that was begun will not go on.
  void abandon() { is_in_program_ = false; }
  /// Modal state, modal calls, local and volatile variables go; position and offsets stay.
  void reset() { reset_control(); }
  /// Behind servo().source().reset(), at rest: forgets what was ahead. The control stands where the
  /// axes do; program and alarm are as they were.
  void drop_ahead();

  // By hand

  /// A move that the operator commands, from where the axes rest, without the beam of a laser;
  /// finish_moves() behind the last one. Otherwise why the joints cannot follow it; then nothing
  /// has changed.
  [[nodiscard]] std::optional<control::Refusal> command(const motion::Motion& motion);
  void finish_moves() { servo().finish(); }
  /// Why the joints could not follow a move from where the axes rest.
  [[nodiscard]] std::optional<control::Refusal> objection(const motion::Motion& motion) {
    return refusal(servo().commanded(), motion, JointWatch::Intent::ask);
  }
  /// Brings the motors back to where every counter is 0, clear of the work; false: they are there.
  /// Precondition: the machine makes patterns, and the axes rest.
  bool command_way_to_start();

  // To a line

  /// While on, motions go to `sink` and to nobody else: the control comes to a line without moving
  /// anything. Null: off.
  void divert_motions(motion::MotionSink* sink);
  /// Of a diverted run: at most so many steps. False: it has not halted.
  bool execute(std::uint64_t steps);
  /// Behind a diverted run: the program waits where it has halted. Joints are where they stand.
  void stand_by();

 private:
  [[nodiscard]] bool ready() const override;
  [[nodiscard]] bool axes_have_arrived() override;
  [[nodiscard]] double seconds() override { return servo().time_s(); }
  [[nodiscard]] bool input_can_be_read() override;
  [[nodiscard]] bool admits(const motion::Motion& motion) override;

  bool begin(std::optional<base::Diagnostic> alarm);
  void execute_ahead();
  void settle();
  void settle_by_hand();
  void settle_in_program();
  void end_program(RunStatus status);

  std::function<void()> at_rest_;
  std::function<bool()> input_ready_;
  motion::MotionSink* diverted_ = nullptr;
  bool is_active_ = false;
  bool is_in_program_ = false;
  bool executes_ = false;    // the control has not halted
  bool is_by_hand_ = false;  // what moves was commanded by the operator
  bool waits_for_input_ = false;
  std::uint64_t turns_ = 0;  // of the control, behind so many points:
  std::uint64_t turns_at_ = 0;
};

}  // namespace kerf::machine
