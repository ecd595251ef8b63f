#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/program_text.hpp"
#include "control/core/memory.hpp"
#include "machine/panel/panel.hpp"
#include "machine/panel/range.hpp"
#include "machine/run/breakpoint.hpp"
#include "machine/run/stepper.hpp"

namespace kerf::machine {

// What an operator does, one struct for each key. The ranges are what whoever reads one from
// foreign text holds it to; what a machine cannot do now it refuses.

/// Loads a program; mode edit, auto, or any other while nothing runs.
struct Load {
  base::ProgramText program;
  std::string dialect{};  ///< of available_dialects(); empty: that of the settings
};
struct SetMode {
  Mode mode = Mode::automatic;
};
struct CycleStart {};
/// At any instant, by the interpolator.
struct FeedHold {};
/// The axes come to rest, what was ahead is forgotten; alarm and modes go. Never refused.
struct Reset {};
struct TurnSwitch {
  Switch which = Switch::single_block;
  bool on = false;
};
/// One bit per level: bit n for /n. Acts on the first block that the axes have not begun
/// (docs/stepping.md, "Switches"); slow where the program has slashes that the control has read
/// already.
struct SetBlockSkip {
  static constexpr Range kLevels{1, 9};
  std::uint32_t levels = 0;
};
/// The signal of a macro interrupt (M96): its program runs behind the block that the axes are in.
/// A signal that meets no M96 in force is told as a message.
struct Interrupt {};
/// An input at any time: a program reads it when the axes have come to the block. It stays for the
/// programs that follow.
struct SetInput {
  static constexpr Range kInputs{1000, 1035};
  static constexpr Range kValues{-2147483648.0, 4294967295.0};
  std::string name;  ///< "#1000" to "#1035"
  double value = 0;
};
/// Percent; a dial that has none stays where it stands.
struct SetDials {
  static constexpr Range kFeed{0, 200};
  static constexpr Range kRapid{0, 100};
  static constexpr Range kSpindle{50, 120};
  std::optional<int> feed{};
  std::optional<int> rapid{};
  std::optional<int> spindle{};
};
/// Moves an axis until JogStop or the end of its travel, which is an alarm (OT0500, OT0501).
struct Jog {
  static constexpr Range kSpeeds_per_min{-1e6, 1e6};
  std::string axis;
  double speed_per_min = 0;  ///< mm or degrees a minute, the sign is the direction
};
/// By a distance.
struct JogBy {
  static constexpr double kMostDistance = 36000;
  std::string axis;
  double distance = 0;       ///< mm or degrees; of a diameter as its position counts
  double speed_per_min = 0;  ///< > 0, or 0: that of the settings
};
struct JogStop {};
/// All axes to their first reference points, the tool's axis first.
struct Home {};
/// Executes blocks; only in mode mdi. Their end is the end of the entry.
struct EnterBlocks {
  static constexpr std::size_t kMostBytes = 4096;
  std::string text;
};
/// A line for INPUT.
struct EnterLine {
  static constexpr std::size_t kMostBytes = 200;
  std::string text;
};
struct TakeStep {
  Step how = Step::over;
};
/// One block back: the run is made again from its start to there (docs/stepping.md).
struct StepBack {};
/// Goes on until the line is to be executed the next time.
struct RunTo {
  std::string file;  ///< empty: the loaded program
  std::uint32_t line = 0;
};
/// Stands before a line of the main program, with the modal state of whoever comes there. Nothing
/// moves: cycle start brings the axes to where the program has them, the tool's axis last, and goes
/// on.
struct StartAt {
  std::uint32_t line = 0;
};
/// All of them.
struct SetBreakpoints {
  std::vector<Breakpoint> list;
};
/// While nothing moves: at rest, held, in a dwell. Acts on the first block that the axes have not
/// begun. The name of an input: SetInput.
struct SetVariable {
  static constexpr Range kLevels{0, 1000};
  std::string name;
  std::optional<double> value{};       ///< nothing: vacant
  std::optional<std::size_t> level{};  ///< of the calls, 0: main; nothing: the innermost
};
/// While nothing moves.
struct SetOffset {
  static constexpr double kMost = 999999.999;  ///< either side of 0
  std::string offset;  ///< "G54" … "G59", "EXT", "G54.1 P3" with an axis, or
                       ///< "tool.5.length_geometry"; of lathes "tool.5.geometry_x"
                       ///< (control::parts_of)
  std::string axis{};
  double value = 0;  ///< mm or degrees; of a diameter what programs say
};
/// A lathe's tool is measured while nothing moves: its geometry becomes the one with which the axis
/// reads `reads` where it stands, in the work system in force.
struct MeasureOffset {
  static constexpr Range kNumbers{1, 999};
  std::int64_t number = 0;  ///< of the tool offset
  std::string axis;         ///< X, Y or Z
  double reads = 0;         ///< mm, as the position is shown: what was turned, or faced
};
/// Takes entries back. Precondition: nothing moves, and it is a memory of this machine. Never
/// refused.
struct SetMemory {
  control::Memory memory;
};
/// For whoever takes points and cannot follow them, as the alarm of a drive. Never refused.
struct Raise {
  base::Diagnostic alarm;
};

/// A key of the panel, with what belongs to it.
using Operation =
    std::variant<Load, SetMode, CycleStart, FeedHold, Reset, TurnSwitch, SetBlockSkip, Interrupt,
                 SetInput, SetDials, Jog, JogBy, JogStop, Home, EnterBlocks, EnterLine, TakeStep,
                 StepBack, RunTo, StartAt, SetBreakpoints, SetVariable, SetOffset, MeasureOffset,
                 SetMemory, Raise>;

}  // namespace kerf::machine
