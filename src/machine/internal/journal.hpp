#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "machine/internal/live_core.hpp"

namespace kerf::machine {

/// A run as it was driven: what it began with, and what the operator did behind how many points.
/// From that it can be made again (docs/stepping.md).
struct Journal {
  struct Entry {
    std::uint64_t points = 0;
    std::function<base::Outcome<void>(LiveCore&)> act;
    /// Instead of an act: from here on the program stops before the block of this number, 0: not.
    std::optional<std::uint64_t> last_block{};
  };
  RunStart start;
  std::uint64_t run = 0;
  std::vector<Entry> entries;

  /// The run was made again up to before a block, behind its first `kept` entries and `points`
  /// points: forgets the others, and notes the stop.
  void go_back(std::uint64_t block, std::size_t kept, std::uint64_t points);
};

/// Lets a core make points up to a time and a number of them, or until nothing moves or executes.
void make_points(LiveCore& core, double until_s, std::uint64_t most);

/// A run that is made again.
class Replay {
 public:
  /// The journal must outlive the replay and only grow. Blocks are counted; with `last_block` the
  /// program stops before the block of that number, and what the operator did from there on is left
  /// out.
  explicit Replay(const Journal& journal, std::uint64_t last_block = 0);

  /// On to a time of the run, infinite: to the end of what is recorded.
  void go_to(double time_s);
  [[nodiscard]] LiveCore& core() { return *core_; }
  [[nodiscard]] double time_s() const { return core_->time_s(); }
  /// Entries that were done again.
  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::unique_ptr<LiveCore> take() { return std::move(core_); }

 private:
  [[nodiscard]] bool is_at_last_block();
  void stop_before(std::uint64_t recorded);

  const Journal& journal_;
  std::uint64_t last_block_;
  std::unique_ptr<LiveCore> core_;
  std::size_t done_ = 0;
};

}  // namespace kerf::machine
