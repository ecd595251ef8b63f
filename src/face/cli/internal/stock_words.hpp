#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "face/cli/commands.hpp"
#include "job/stock_job.hpp"

namespace kerf::cli {

// Words of `kerf stock` that are read here. Failure (usage): the option and what is wrong with it.

/// `--until`: a line, or seconds ("12.5s"). Empty: none.
[[nodiscard]] base::Outcome<std::optional<job::CutUntil>> until_of(const std::string& word);

/// `--tolerance`, `--gouge`, `--excess`.
[[nodiscard]] base::Outcome<stock::compare::Tolerance> tolerance_of(const CompareOptions& options);
/// Nothing is said of a comparison that is not made.
[[nodiscard]] base::Outcome<void> check_comparison(const CompareOptions& options);

}  // namespace kerf::cli
