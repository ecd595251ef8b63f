#include "face/cli/stock_words.hpp"

#include <limits>

#include "base/decimal.hpp"

namespace kerf::cli {

using base::Outcome;

Outcome<std::optional<job::CutUntil>> until_of(const std::string& word) {
  if (word.empty()) return std::optional<job::CutUntil>{};
  if (word.back() == 's') {
    const double time_s = base::read_number(word.substr(0, word.size() - 1)).value_or(-1);
    if (time_s >= 0) return std::optional(job::CutUntil{.time_s = time_s});
  } else if (const auto line = base::read_whole_number(word);
             line && *line > 0 && *line <= std::numeric_limits<std::uint32_t>::max()) {
    return std::optional(job::CutUntil{.line = static_cast<std::uint32_t>(*line)});
  }
  return base::usage("--until " + word + ": a line is expected, or seconds as in 12.5s");
}

}  // namespace kerf::cli
