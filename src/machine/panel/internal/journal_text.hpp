#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "machine/panel/internal/journal.hpp"

namespace kerf::machine {

/// A journal, and the moment up to which it tells.
struct ToldJournal {
  Journal journal;
  LiveCore::Moment until;
};

/// A journal as a file: JSON of version 1 (docs/journal.md). Failure (input): as
/// LiveMachine::journal().
[[nodiscard]] base::Outcome<std::string> journal_text(const ToldJournal& told);

/// Back. Every value is held against its range; library folders are not in the file. Failure
/// (input): it is no journal, or damaged.
[[nodiscard]] base::Outcome<ToldJournal> read_journal(std::string_view text,
                                                      std::vector<std::string> library_folders);

}  // namespace kerf::machine
