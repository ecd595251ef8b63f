#include "machine/panel/internal/read_again.hpp"

#include <algorithm>
#include <limits>

#include "machine/run/first_block.hpp"

namespace kerf::machine {
namespace {

constexpr double kWheneverThatIs = std::numeric_limits<double>::infinity();

/// Tries blocks.
class Attempt {
 public:
  Attempt(const Journal& journal, LiveCore& now, const Journal::Act& shown,
          const Journal::Act& effect)
      : journal_(journal), now_(now), shown_(shown), effect_(effect) {}

  /// Counts the blocks that were begun and those that were read.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> blocks() const {
    Replay replay(journal_);
    replay.core().set_limit(now_.limit());
    replay.go_to(kWheneverThatIs, now_.moment());
    return {replay.core().begun().blocks, replay.core().read().blocks};
  }

  /// What the operator did before that waits for a later block counts from this one on, too: it
  /// must not come behind what he does now.
  [[nodiscard]] std::optional<ReadAgain> from(std::uint64_t block) const {
    ReadAgain again{journal_, nullptr};
    for (Journal::Entry& entry : again.journal.entries) {
      if (entry.ahead) entry.ahead->block = std::min(entry.ahead->block, block);
    }
    again.journal.entries.push_back({now_.moment(), shown_, {}, Journal::Ahead{block, effect_}});
    Replay replay(again.journal);
    replay.core().set_limit(now_.limit());
    replay.go_to(kWheneverThatIs, now_.moment());
    if (now_.limit().reached() || !replay.core().moves_as(now_) || replay.core().has_refused())
      return std::nullopt;
    again.core = replay.take();
    return again;
  }

 private:
  const Journal& journal_;
  LiveCore& now_;
  const Journal::Act& shown_;
  const Journal::Act& effect_;
};

}  // namespace

std::optional<ReadAgain> read_again(const Journal& journal, LiveCore& now,
                                    const Journal::Act& shown, const Journal::Act& effect) {
  const Attempt attempt(journal, now, shown, effect);
  const auto [begun, read] = attempt.blocks();
  if (now.limit().reached() || read <= begun) return std::nullopt;
  return at_first_block(begun + 1, read, [&](std::uint64_t block) { return attempt.from(block); });
}

}  // namespace kerf::machine
