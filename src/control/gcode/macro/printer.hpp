#pragma once

#include <string>

#include "control/core/parameters.hpp"
#include "control/core/surroundings.hpp"
#include "lang/gcode/page.hpp"

namespace kerf::control {

/// DPRNT and BPRNT: a line for whoever reads the program's output (docs/dialect/macros.md §7).
class Printer {
 public:
  /// Both must outlive the printer.
  Printer(const Parameters& parameters, Surroundings& surroundings)
      : parameters_(parameters), surroundings_(surroundings) {}

  void print(const gcode::GcodePage& page, const gcode::Statement& statement,
             const double* registers);

 private:
  const Parameters& parameters_;
  Surroundings& surroundings_;
  std::string line_;
};

}  // namespace kerf::control
