#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "machine/run/batch_run.hpp"
#include "motion/motion.hpp"

namespace kerf::test {

/// How a program is run.
struct RunSetup {
  std::string machine = "mill3";
  std::vector<std::pair<std::string, std::string>> parameters{};
  /// Radius of tool offset D1; 0: none.
  double radius_of_d1 = 0;
};

/// What a program did.
struct RunResult {
  machine::RunStatus status{};
  std::string alarm{};  ///< "PS0010 in line 3", or empty
  std::vector<motion::Motion> motions{};
  double cut_mm = 0;
  double seconds = 0;
  base::TipPoint low{};
  base::TipPoint high{};
  base::AxisVector position{};
};

/// Runs a program from its text.
[[nodiscard]] RunResult run_program(const std::string& program, const RunSetup& setup = {});

/// The moves alone: everything with a target.
[[nodiscard]] std::vector<motion::Motion> moves_of(const RunResult& result);

/// A motion for a reader: "line X1 Y2 Z0 F100".
[[nodiscard]] std::string text_of(const motion::Motion& motion);
[[nodiscard]] std::string text_of(const std::vector<motion::Motion>& motions);

/// What tells two lists of moves apart, the lines that they come from left aside; empty: nothing.
/// Numbers may differ by `tolerance`.
[[nodiscard]] std::string difference(const std::vector<motion::Motion>& got,
                                     const std::vector<motion::Motion>& wanted, double tolerance);

}  // namespace kerf::test
