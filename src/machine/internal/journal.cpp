#include "machine/internal/journal.hpp"

namespace kerf::machine {
namespace {

// Calls of a machine that computes without moving before it counts as endless.
constexpr int kMostIdleCalls = 200;

}  // namespace

Replay::Replay(const Journal& journal, std::uint64_t last_block)
    : journal_(journal), last_block_(last_block), core_(std::make_unique<LiveCore>(journal.start)) {
  core_->set_run(journal.run);
  core_->stepper().count_blocks(true);
  core_->stepper().search_block(last_block);
}

bool Replay::is_at_last_block() {
  return last_block_ != 0 && core_->stepper().blocks() >= last_block_;
}

// What the operator did at a number of points was done when all was ready behind the last of them.
void Replay::make_points(double until_s, std::uint64_t most) {
  int idle = 0;
  while (core_->is_active() && idle < kMostIdleCalls) {
    const std::uint64_t before = core_->points();
    const std::uint64_t blocks = core_->stepper().blocks();
    core_->advance_to(until_s, most);
    if (core_->is_active() && core_->is_reached()) return;
    idle = before == core_->points() && blocks == core_->stepper().blocks() ? idle + 1 : 0;
  }
}

void Replay::go_to(double time_s) {
  constexpr auto kAll = std::numeric_limits<std::uint64_t>::max();
  for (; done_ < journal_.entries.size(); ++done_) {
    const Journal::Entry& entry = journal_.entries[done_];
    make_points(time_s, entry.points);
    if (core_->points() < entry.points || is_at_last_block()) break;
    static_cast<void>(entry.act(*core_));
  }
  if (last_block_ != 0 || time_s < std::numeric_limits<double>::infinity())
    make_points(time_s, kAll);
}

}  // namespace kerf::machine
