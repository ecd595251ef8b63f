#pragma once

#include <cstdint>
#include <string>

namespace kerf::machine {

/// Where or when a program is to stop: before a line, or when a variable has got another value.
struct Breakpoint {
  std::string file;        ///< its name, or the end of it behind a slash; empty: the loaded program
  std::uint32_t line = 0;  ///< from 1; 0: it is a variable's
  std::string condition;   ///< in the language of the program; empty: always
  std::string variable;    ///< "#100", "COUNT"
  friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// The breakpoint that has stopped a program.
struct BreakpointHit {
  Breakpoint breakpoint;
  std::uint32_t written_line = 0;  ///< of a variable's: the line that has written it
  double before = 0;               ///< likewise; vm::kNull: vacant
  double after = 0;
  std::string trouble;  ///< why the condition has no value; the program stops then, too
};

}  // namespace kerf::machine
