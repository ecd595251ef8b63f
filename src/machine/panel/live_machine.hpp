#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "base/work_limit.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/variable_listing.hpp"
#include "machine/panel/operation.hpp"
#include "machine/panel/snapshot.hpp"
#include "motion/axis_point.hpp"

namespace kerf::machine {

/// A machine as its operator has it: a PacedRun that is run by simulated time, with the
/// modes, switches and keys of a panel.
///
///   LiveMachine machine(definition, memory);
///   machine.perform(Load{text});
///   machine.perform(CycleStart{});
///   for (;;) { machine.advance(0.02); show(machine.snapshot()); }
///
/// It has neither threads nor clocks: who calls advance() decides how fast time goes.
/// Deterministic: the same commands behind the same set-points give the same bytes, however the
/// time between them is cut, and a run without any is that of PacedRun::run_to_end().
///
/// What an operator cannot do now is refused in words (Failure, usage), and changes nothing.
/// Each program, and each MDI entry after a reset, begins in the state of power-on but for memory,
/// position, G92 shift and input signals.
class LiveMachine {
 public:
  using Outcome = base::Outcome<void>;

  struct Settings {
    std::string dialect{};  ///< of available_dialects(); empty: the machine's own
    std::vector<std::string> library_folders{};
    /// The machine file that the definition was read from, for journal(). Empty: there is none.
    std::string machine_file{};
    double jog_mm_min = 1000;           ///< of dry run, and of jog where no speed is given
    double jog_deg_min = 1800;          ///< likewise, of rotary axes
    std::size_t printed_bytes = 65536;  ///< of what the program prints are kept
  };

  LiveMachine(const MachineDefinition& definition, control::Memory memory)
      : LiveMachine(definition, std::move(memory), Settings{}) {}
  LiveMachine(const MachineDefinition& definition, control::Memory memory, Settings settings);
  ~LiveMachine();
  LiveMachine(LiveMachine&&) noexcept;
  LiveMachine& operator=(LiveMachine&&) noexcept;

  // Whoever watches; they must outlive the machine. Motions come when the control hands them out,
  // but for those that it reads again (SetBlockSkip); points when they are made: with start()
  // when the axes stand somewhere else than where the last point was, and when a run begins (its
  // times begin with 0).
  void add_sink(motion::MotionSink& sink);
  void add_point_sink(motion::AxisPointSink& sink);
  /// What the operator does.
  Outcome perform(const Operation& key);

  /// Lets simulated time pass. Bounded work for bounded time: where a program computes without
  /// moving anything, it goes on in the next call.
  void advance(double seconds);
  /// What is to be seen now. Cheap while nothing has changed since the last one.
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot();

  // The program

  /// What a Load would be answered; it changes nothing.
  [[nodiscard]] Outcome can_load(const Load& key) const;
  [[nodiscard]] const std::optional<base::ProgramText>& program() const;
  [[nodiscard]] const std::string& dialect() const;
  /// Mistakes of the loaded program that show without running it.
  [[nodiscard]] std::vector<base::Diagnostic> check();

  [[nodiscard]] const std::vector<Breakpoint>& breakpoints() const;

  // Memory

  /// What variables there are. `level` of the call stack, 0: main; nothing: the innermost.
  [[nodiscard]] VariableListing variables(std::optional<std::size_t> level = {});
  /// Those of these names, in their order; unknown ones are left out.
  [[nodiscard]] VariableListing variables_named(const std::vector<std::string>& names,
                                                std::optional<std::size_t> level = {});
  /// That of the block that is being made; what is read ahead of it does not count. It is what a
  /// reset goes back to, and what is to be on the disk when the power fails.
  [[nodiscard]] control::Memory memory() const;
  [[nodiscard]] const MachineDefinition& definition() const;
  /// The same with its start where the axes stood when the program under way began, otherwise where
  /// they stand: a machine made from it goes the same way.
  [[nodiscard]] MachineDefinition definition_of_run() const;

  /// How long what makes the run again may compute from now on; none at first. Beyond that
  /// StepBack, StartAt and state_at() are refused, and the machine is as it was; state_at()
  /// goes on from there when it is asked again. What an operator changes on the way acts at once
  /// then, not on the block that the axes come to next.
  void set_limit(const base::WorkLimit& limit);

  // Time

  /// The state at a time of this run: up to the time of the last snapshot the run is made again to
  /// there; behind that the loaded program is run as it would be without anybody at the panel, to
  /// its end at most. Slow where that is far; later times go on from there.
  [[nodiscard]] base::Outcome<std::shared_ptr<const Snapshot>> state_at(double time_s);
  /// Variables at the time that state_at() was asked for last.
  [[nodiscard]] VariableListing variables_at_state(std::optional<std::size_t> level = {});

  // What was done

  /// The bytes that a journal has at most, and those of its program.
  static constexpr std::size_t kMostJournalBytes = 32U << 20U;
  static constexpr std::size_t kMostJournalProgramBytes = 8U << 20U;
  /// This run as a file (docs/journal.md): what it began with and what was done since. Failure
  /// (input): it has no machine file, its program cannot be read, or it is too long; the sentence
  /// says which.
  [[nodiscard]] base::Outcome<std::string> journal() const;
  /// Whoever watches a run from its start.
  struct Watchers {
    std::vector<motion::MotionSink*> motions{};
    std::vector<motion::AxisPointSink*> points{};
  };
  /// A machine that has done what a journal says, with the same set-points, and stands where that
  /// one stood. Programs that it calls are looked for in these folders. Failure (input): it is
  /// none, or damaged; (usage): the limit was reached before its end.
  [[nodiscard]] static base::Outcome<LiveMachine> from_journal(
      std::string_view journal, std::vector<std::string> library_folders, const Watchers& watchers,
      const base::WorkLimit& limit);

  // Teaching

  enum class Capture : std::uint8_t { point, line, arc_via, arc_end, circle_end };
  struct Taught {
    std::string text;        ///< the whole program
    std::uint32_t line = 0;  ///< the last one of it
  };
  /// Captures where the axes stand into a taught program; only in mode teach, at rest.
  base::Outcome<Taught> capture(Capture what, std::string_view name = {});
  /// Any other record: "FEED 600", "LASER ON 40", "DWELL 0.5", "END".
  base::Outcome<Taught> teach_record(std::string_view record);
  /// Takes the last record back, or the arc's middle.
  base::Outcome<Taught> take_back();
  [[nodiscard]] Taught taught() const;
  void new_teaching();

 private:
  class Impl;
  explicit LiveMachine(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace kerf::machine
