#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/program_text.hpp"
#include "base/result.hpp"
#include "base/work_limit.hpp"
#include "control/core/memory.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/variable_listing.hpp"
#include "machine/panel/panel.hpp"
#include "machine/panel/snapshot.hpp"
#include "machine/run/breakpoint.hpp"
#include "machine/run/stepper.hpp"
#include "motion/axis_point.hpp"

namespace kerf::machine {

/// A machine as its operator has it: a PacedRun that is run by simulated time, with the
/// modes, switches and keys of a panel.
///
///   LiveMachine machine(definition, memory);
///   machine.load(text);
///   machine.cycle_start();
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
  // but for those that it reads again (set_block_skip()); points when they are made: with start()
  // when the axes stand somewhere else than where the last point was, and when a run begins (its
  // times begin with 0).
  void add_sink(motion::MotionSink& sink);
  void add_point_sink(motion::AxisPointSink& sink);
  /// For whoever takes points and cannot follow them, as the alarm of a drive.
  void raise(const base::Diagnostic& alarm);

  /// Lets simulated time pass. Bounded work for bounded time: where a program computes without
  /// moving anything, it goes on in the next call.
  void advance(double seconds);
  /// What is to be seen now. Cheap while nothing has changed since the last one.
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot();

  // The program

  /// Loads a program; mode edit, auto, or any other while nothing runs. The program's language is
  /// `dialect`, one of available_dialects(); empty: that of the settings.
  Outcome load(base::ProgramText program, std::string dialect = {});
  /// What load() would say; it changes nothing.
  [[nodiscard]] Outcome can_load(const base::ProgramText& program,
                                 const std::string& dialect) const;
  [[nodiscard]] const std::optional<base::ProgramText>& program() const;
  [[nodiscard]] const std::string& dialect() const;
  /// Mistakes of the loaded program that show without running it.
  [[nodiscard]] std::vector<base::Diagnostic> check();

  // The panel

  Outcome set_mode(Mode mode);
  Outcome cycle_start();
  /// At any instant, by the interpolator.
  Outcome feed_hold();
  /// The axes come to rest, what was ahead is forgotten; alarm and modes go.
  void reset();
  Outcome set_switch(Switch which, bool on);
  /// One bit per level: bit n for /n, n = 1 to 9. Acts on the first block that the axes have not
  /// begun (docs/stepping.md, "Switches"); slow where the program has slashes that the control has
  /// read already.
  Outcome set_block_skip(std::uint32_t levels);
  /// The signal of a macro interrupt (M96): its program runs behind the block that the axes are in.
  /// A signal that meets no M96 in force is told as a message.
  Outcome interrupt();
  /// An input, "#1000" to "#1035", at any time: a program reads it when the axes have come to the
  /// block. It stays for the programs that follow.
  Outcome set_input(const std::string& name, double value);
  Outcome set_dials(const OverrideDials& dials);
  /// Moves an axis until jog_stop() or the end of its travel, which is an alarm (OT0500, OT0501).
  /// `speed_per_min`: mm or degrees a minute, the sign is the direction.
  Outcome jog(std::string_view axis, double speed_per_min);
  /// By a distance, mm or degrees. `speed_per_min` > 0, or 0: that of the settings.
  Outcome jog_by(std::string_view axis, double distance, double speed_per_min = 0);
  Outcome jog_stop();
  /// All axes to their first reference points, the tool's axis first.
  Outcome home();
  /// Executes blocks; only in mode mdi. Their end is the end of the entry.
  Outcome mdi(std::string text);
  /// A line for INPUT.
  Outcome enter(std::string line);

  // Stepping

  Outcome step(Step how);
  /// One block back: the run is made again from its start to there (docs/stepping.md).
  Outcome step_back();
  /// Goes on until the line is to be executed the next time. `file` empty: the loaded program.
  Outcome run_to(std::string file, std::uint32_t line);
  /// Stands before a line of the main program, with the modal state of whoever comes there. Nothing
  /// moves: cycle start brings the axes to where the program has them, the tool's axis last, and
  /// goes on.
  Outcome start_at(std::uint32_t line);
  Outcome set_breakpoints(std::vector<Breakpoint> breakpoints);
  [[nodiscard]] const std::vector<Breakpoint>& breakpoints() const;

  // Memory

  /// What variables there are. `level` of the call stack, 0: main; nothing: the innermost.
  [[nodiscard]] VariableListing variables(std::optional<std::size_t> level = {});
  /// Those of these names, in their order; unknown ones are left out.
  [[nodiscard]] VariableListing variables_named(const std::vector<std::string>& names,
                                                std::optional<std::size_t> level = {});
  /// While nothing moves: at rest, held, in a dwell. Nothing: vacant. Acts on the first block that
  /// the axes have not begun. The name of an input: set_input().
  Outcome set_variable(const std::string& name, std::optional<double> value,
                       std::optional<std::size_t> level = {});
  /// While nothing moves. `offset`: "G54" … "G59", "EXT", "G54.1 P3" with an axis, or
  /// "tool.5.length_geometry" (length_wear, radius_geometry, radius_wear) without one; mm.
  Outcome set_offset(const std::string& offset, std::string_view axis, double value);
  /// That of the block that is being made; what is read ahead of it does not count. It is what a
  /// reset goes back to, and what is to be on the disk when the power fails.
  [[nodiscard]] control::Memory memory() const;
  /// Takes entries back. Precondition: nothing moves, and it is a memory of this machine.
  void set_memory(control::Memory memory);
  [[nodiscard]] const MachineDefinition& definition() const;
  /// The same with its start where the axes stood when the program under way began, otherwise where
  /// they stand: a machine made from it goes the same way.
  [[nodiscard]] MachineDefinition definition_of_run() const;

  /// How long what makes the run again may compute from now on; none at first. Beyond that
  /// step_back(), start_at() and state_at() are refused, and the machine is as it was; state_at()
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
  std::unique_ptr<Impl> impl_;
};

}  // namespace kerf::machine
