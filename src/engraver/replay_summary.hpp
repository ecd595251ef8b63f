#pragma once

#include <optional>
#include <string>

#include "base/diagnostic.hpp"
#include "engraver/pattern_replay.hpp"

namespace kerf::engraver {

/// What a replay does not know of itself.
struct ReplaySummary {
  std::string file;
  std::optional<base::Diagnostic> alarm;  ///< with the offset of its record
  bool budget_spent = false;              ///< it ended before the pattern did
};

/// The summary of a replay as one JSON object on one line (docs/pattern.md).
[[nodiscard]] std::string replay_json(const PatternReplay& replay, const ReplaySummary& summary);

/// The same for people: a few lines of text.
[[nodiscard]] std::string replay_text(const PatternReplay& replay, const ReplaySummary& summary);

}  // namespace kerf::engraver
