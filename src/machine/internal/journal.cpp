#include "machine/internal/journal.hpp"

#include <algorithm>

namespace kerf::machine {
namespace {

// Calls of a machine that computes without moving before it counts as endless.
constexpr int kMostIdleCalls = 200;

}  // namespace

// What an operator did at a number of points was done when all was ready behind the last of them.
void make_points(LiveCore& core, double until_s, std::uint64_t most) {
  int idle = 0;
  while (core.is_active() && idle < kMostIdleCalls) {
    const std::uint64_t before = core.points();
    const std::uint64_t blocks = core.stepper().blocks();
    core.advance_to(until_s, most);
    if (core.is_active() && core.is_reached()) return;
    idle = before == core.points() && blocks == core.stepper().blocks() ? idle + 1 : 0;
  }
}

// The stop belongs where the last one before it was called off.
void Journal::go_back(std::uint64_t block, std::size_t kept, std::uint64_t points) {
  entries.resize(kept);
  const auto last = std::find_if(entries.rbegin(), entries.rend(),
                                 [](const Entry& entry) { return entry.last_block.has_value(); });
  if (last != entries.rend()) {
    last->last_block = block;
  } else {
    entries.insert(entries.begin(), Entry{0, {}, block});
  }
  entries.push_back({points, {}, 0});
}

Replay::Replay(const Journal& journal, std::uint64_t last_block)
    : journal_(journal), last_block_(last_block), core_(std::make_unique<LiveCore>(journal.start)) {
  core_->set_run(journal.run);
  core_->stepper().count_blocks(true);
  stop_before(0);
}

void Replay::stop_before(std::uint64_t recorded) {
  const bool recorded_first = recorded != 0 && (last_block_ == 0 || recorded < last_block_);
  core_->stepper().search_block(recorded_first ? recorded : last_block_);
}

bool Replay::is_at_last_block() {
  return last_block_ != 0 && core_->stepper().blocks() >= last_block_;
}

void Replay::go_to(double time_s) {
  constexpr auto kAll = std::numeric_limits<std::uint64_t>::max();
  for (; done_ < journal_.entries.size(); ++done_) {
    const Journal::Entry& entry = journal_.entries[done_];
    make_points(*core_, time_s, entry.points);
    if (core_->points() < entry.points || is_at_last_block()) break;
    if (entry.last_block) {
      stop_before(*entry.last_block);
    } else {
      static_cast<void>(entry.act(*core_));
    }
  }
  make_points(*core_, time_s, kAll);
}

}  // namespace kerf::machine
