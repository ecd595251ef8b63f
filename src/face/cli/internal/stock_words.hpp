#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "face/cli/commands.hpp"
#include "job/stock_job.hpp"
#include "machine/definition/set_up.hpp"

namespace kerf::cli {

// Words of `kerf stock` that are read here. Failure (usage): the option and what is wrong with it.

/// `--until`: a line, or seconds ("12.5s"). Empty: none.
[[nodiscard]] base::Outcome<std::optional<job::CutUntil>> until_of(const std::string& word);

/// What a set-up says of the design, and the words of a command line, which count more.
[[nodiscard]] base::Outcome<machine::SetUp> with_design(const CompareOptions& options,
                                                        machine::SetUp set_up);
/// `--tolerance`, `--gouge`, `--excess`, else that of the design.
[[nodiscard]] base::Outcome<stock::compare::Tolerance> tolerance_of(
    const CompareOptions& options, const std::optional<machine::SetUp::Design>& design);
/// Nothing is said of a comparison that is not made.
[[nodiscard]] base::Outcome<void> check_comparison(
    const CompareOptions& options, const std::optional<machine::SetUp::Design>& design);

}  // namespace kerf::cli
