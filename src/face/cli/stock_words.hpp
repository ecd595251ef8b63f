#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "face/cli/commands.hpp"
#include "job/stock_job.hpp"
#include "machine/definition/set_up.hpp"

namespace kerf::cli {

/// What the words of a command line and the file of their set-up say together; the words count
/// more. Failure (usage): a word is wrong; (input): the file cannot be read.
[[nodiscard]] base::Outcome<machine::SetUp> set_up_of(const TableOptions& options);

/// Whether something lies on the table. Failure (usage): it is spoken of, and nothing does.
[[nodiscard]] base::Outcome<bool> has_table(const TableOptions& options);

/// What is not a matter of the set-up: cells, memory, threads, where the axes begin. Failure
/// (usage).
[[nodiscard]] base::Outcome<void> take_means(const TableOptions& options, job::StockJob& job);

/// `--until`: a line, or seconds ("12.5s"). Empty: none.
[[nodiscard]] base::Outcome<std::optional<job::CutUntil>> until_of(const std::string& word);

}  // namespace kerf::cli
