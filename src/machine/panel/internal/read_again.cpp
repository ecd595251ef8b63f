#include "machine/panel/internal/read_again.hpp"

#include <limits>

#include "machine/run/first_block.hpp"

namespace kerf::machine {
namespace {

constexpr double kWheneverThatIs = std::numeric_limits<double>::infinity();

/// Tries blocks.
class Attempt {
 public:
  Attempt(const Journal& journal, LiveCore& now, const Operation& key)
      : journal_(journal), now_(now), key_(key) {}

  /// Counts the blocks that were begun and those that were read.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> blocks() const {
    Replay replay(journal_);
    replay.core().set_limit(now_.limit());
    replay.go_to(kWheneverThatIs, now_.moment());
    return {replay.core().run().begun().blocks, replay.core().run().read().blocks};
  }

  /// What the operator did before that waits for a later block counts from this one on, too: it
  /// must not come behind what he does now.
  [[nodiscard]] std::optional<ReadAgain> from(std::uint64_t block) const {
    ReadAgain again{journal_, nullptr};
    again.journal.bring_forward(block);
    again.journal.entries.push_back({now_.moment(), key_, block});
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
  const Operation& key_;
};

}  // namespace

std::optional<ReadAgain> read_again(const Journal& journal, LiveCore& now, const Operation& key) {
  const Attempt attempt(journal, now, key);
  const auto [begun, read] = attempt.blocks();
  if (now.limit().reached() || read <= begun) return std::nullopt;
  return at_first_block(begun + 1, read, [&](std::uint64_t block) { return attempt.from(block); });
}

}  // namespace kerf::machine
