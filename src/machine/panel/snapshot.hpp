#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/axes.hpp"
#include "machine/panel/panel.hpp"
#include "machine/run/breakpoint.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

/// One level of the calls that are open.
struct CallLevel {
  std::string program;     ///< "O0001"
  std::string file;        ///< as it was loaded
  std::uint32_t line = 0;  ///< the block that executes next; of a caller, that of the call
  std::size_t level = 0;   ///< 0: main
  friend bool operator==(const CallLevel&, const CallLevel&) = default;
};

/// An alarm in words.
struct AlarmText {
  std::string code;  ///< "PS0010"
  std::string message;
  std::string program;
  std::string file;        ///< empty: it has no place
  std::uint32_t line = 0;  ///< from 1; 0: no place
  std::uint32_t column = 0;
  std::uint32_t length = 0;
  std::string cause;
  std::string remedy;
  friend bool operator==(const AlarmText&, const AlarmText&) = default;
};

/// What a panel shows of its machine at one moment. A value: it does not change, and outlives the
/// machine.
///
/// While axes move, block, modal codes, calls and variables are those of the motion that is being
/// made, however far the control has looked ahead; at rest they are those of the control.
struct Snapshot {
  Status status = Status::idle;
  PanelSettings panel;

  std::string program;  ///< "O0001"; empty: none is loaded
  std::string file;
  std::uint32_t line = 0;
  std::string text;           ///< of the line
  double time_s = 0;          ///< of this run; time in which nothing moves counts only while held
  std::uint64_t run = 0;      ///< counts the programs started, jogs and MDI included
  std::uint64_t motion = 0;   ///< the motion under way, from 1 in the order of this run; 0: none
  std::uint64_t motions = 0;  ///< handed out by the control so far

  // In the order of AxisSetup, mm and degrees; of a diameter the way of the axis, its half.
  base::MachinePoint machine;
  base::AxisVector work;      ///< as the program counts
  base::AxisVector distance;  ///< to the end of the motion under way
  base::JointPoint joints;    ///< in the order of the machine file

  std::vector<std::string> modal;     ///< each control's own list: "G01", "F200"
  double feed_programmed_mm_min = 0;  ///< degrees/min where only rotary axes turn; 0: none
  double feed_actual_mm_min = 0;      ///< likewise; of the tip
  double feed_mm_rev = 0;             ///< programmed per revolution of the spindle; 0: it is not
  double spindle_rpm = 0;             ///< as it is where the tip is, the dial included
  double surface_m_min = 0;           ///< programmed constant surface speed; 0: the speed is fixed
  double spindle_limit_rpm = 0;       ///< of a surface speed; 0: there is none
  motion::Spindle::Turning spindle = motion::Spindle::Turning::stopped;
  motion::Coolant::State coolant = motion::Coolant::State::off;
  std::uint32_t tool = 0;
  std::uint32_t tool_offset = 0;  ///< of a lathe: the number in force, 0: none
  double power_percent = 0;       ///< the dial included
  bool beam = false;              ///< off while the axes rest on their way

  std::optional<AlarmText> alarm;
  std::vector<std::string> messages;     ///< of the program and of the panel, the newest last
  std::vector<CallLevel> stack;          ///< main first
  std::uint64_t variables_revision = 0;  ///< another number: some variable may have another value
  std::string printed;                   ///< the end of what the program has printed
  std::uint64_t printed_bytes = 0;       ///< all that it has printed
  bool waits_for_input = false;          ///< INPUT waits for a line of the operator
  /// Signals from outside: bits #1000 to #1015, words #1033 to #1035.
  std::array<std::uint32_t, 4> inputs{};
  std::optional<BreakpointHit> breakpoint;
};

}  // namespace kerf::machine
