#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

/// A run as it was driven: what it began with, and what the operator did at which moments. From
/// that it can be made again (docs/stepping.md).
struct Journal {
  using Act = std::function<base::Outcome<void>(LiveCore&)>;
  /// What is done before a block of this number is executed, which is before the axes come to it.
  struct Ahead {
    std::uint64_t block = 0;
    Act act;
  };
  struct Entry {
    LiveCore::Moment at;
    Act act;
    /// Instead of an act: from here on the program stops before the block of this number, 0: not.
    std::optional<std::uint64_t> last_block{};
    /// Besides the act.
    std::optional<Ahead> ahead{};
  };
  RunStart start;
  std::uint64_t run = 0;
  std::vector<Entry> entries;

  /// The run was made again up to before a block, behind its first `kept` entries: forgets the
  /// others, and notes the stop at `now`.
  void go_back(std::uint64_t block, std::size_t kept, const LiveCore::Moment& now);
};

/// Lets a core go on up to a time and a moment, or until nothing moves or executes, or its limit is
/// reached.
void make_points(LiveCore& core, double until_s, const LiveCore::Moment& last);

/// A run that is made again.
class Replay {
 public:
  /// The journal must outlive the replay and only grow. Blocks are counted; with `last_block` the
  /// program stops before the block of that number, and what the operator did from there on is left
  /// out.
  explicit Replay(const Journal& journal, std::uint64_t last_block = 0);

  /// On to a time of the run, infinite: to the end of what is recorded.
  void go_to(double time_s) { go_to(time_s, LiveCore::kNever); }
  /// Likewise, and not beyond a moment.
  void go_to(double time_s, const LiveCore::Moment& last);
  [[nodiscard]] LiveCore& core() { return *core_; }
  [[nodiscard]] double time_s() const { return core_->time_s(); }
  /// Entries that were done again.
  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::unique_ptr<LiveCore> take() { return std::move(core_); }

 private:
  [[nodiscard]] bool is_at(const LiveCore::Moment& moment);
  [[nodiscard]] bool is_at_last_block();
  void stop_before(std::uint64_t recorded);

  const Journal& journal_;
  std::uint64_t last_block_;
  std::unique_ptr<LiveCore> core_;
  std::size_t done_ = 0;
};

}  // namespace kerf::machine
