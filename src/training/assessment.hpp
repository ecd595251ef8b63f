#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "training/criterion.hpp"
#include "training/exercise.hpp"

namespace kerf::training {

/// How good a program is, held against the solution of its exercise.
struct Assessment {
  std::vector<Criterion> criteria;

  /// 0 to 100: 100 only if every criterion is met.
  [[nodiscard]] int score() const;
};

/// Runs program and solution on a machine of the exercise each, and compares what they do. In which
/// order and direction is cut does not matter, nor how the program is written. Cuts count as the
/// same where they are within the tolerance and made with the same tool, power and slant. Runs are
/// bounded in computing and cutting: a program that does not end is told to do so.
///
/// What else is good about a program counts only as far as its work is done: points of all criteria
/// but the first two are in proportion to the share of the cuts that are made.
/// Failure: the exercise itself is wrong. Stopped by `unwanted`, it ends within milliseconds, and
/// what comes back is of no use.
[[nodiscard]] base::Outcome<Assessment> assess(const Exercise& exercise, const std::string& program,
                                               const std::stop_token& unwanted = {});

}  // namespace kerf::training
