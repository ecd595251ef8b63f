#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

/// A run as it was driven: what it began with, and what the operator did at which moments. From
/// that it can be made again (docs/stepping.md). It is data.
struct Journal {
  /// One thing that was done: a key, or a step back.
  struct Entry {
    LiveCore::Moment at;
    std::optional<Operation> key{};
    /// The key acts on the axes: what shows of it is done at the moment, and what it does before a
    /// block of this number is executed, which is before the axes come to it.
    std::optional<std::uint64_t> before_block{};
    /// Instead of a key: from here on the program stops before the block of this number, 0: not.
    std::optional<std::uint64_t> last_block{};
  };
  RunStart start;
  std::uint64_t run = 0;
  std::vector<Entry> entries{};

  /// The run was made again up to before a block, behind its first `kept` entries: forgets those of
  /// the others that have not acted on it, and notes the stop at `now`.
  void go_back(std::uint64_t block, std::size_t kept, const LiveCore::Moment& now);
  /// Whether it acts on the axes, at this block at the latest.
  [[nodiscard]] static bool has_acted(const Entry& entry, std::uint64_t block);
  /// What waits for a later block counts from this one on.
  void bring_forward(std::uint64_t block);
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
