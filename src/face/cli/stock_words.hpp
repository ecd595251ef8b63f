#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "job/stock_job.hpp"

namespace kerf::cli {

// Words of `kerf stock` that are read here. Failure (usage): the option and what is wrong with it.

/// `--until`: a line, or seconds ("12.5s"). Empty: none.
[[nodiscard]] base::Outcome<std::optional<job::CutUntil>> until_of(const std::string& word);

}  // namespace kerf::cli
