#include "machine/panel/internal/journal.hpp"

#include <algorithm>

namespace kerf::machine {
namespace {

// Calls of a machine that computes without moving before it counts as endless.
constexpr int kMostIdleCalls = 200;
// Points between two looks at the limit: some milliseconds.
constexpr std::uint64_t kSliceOfReplay = 50'000;

}  // namespace

void make_points(LiveCore& core, double until_s, const LiveCore::Moment& last) {
  const bool ends = last.turns != LiveCore::Moment::kAllTurns;
  for (int idle = 0; core.is_active() && idle < kMostIdleCalls && !core.limit().reached();) {
    const LiveCore::Moment before = core.moment();
    const std::uint64_t blocks = core.stepper().blocks();
    const bool is_slice = last.points > before.points + kSliceOfReplay;
    const LiveCore::Moment slice_end{before.points + kSliceOfReplay, LiveCore::Moment::kAllTurns};
    core.advance_to(until_s, is_slice ? slice_end : last);
    const LiveCore::Moment now = core.moment();
    const bool at_slice_end = is_slice && now.points >= slice_end.points;
    if (core.is_active() && !at_slice_end && (core.is_reached() || now == last)) return;
    const bool goes_on = now.points != before.points || core.stepper().blocks() != blocks ||
                         (ends && now.turns != before.turns);
    idle = goes_on ? 0 : idle + 1;
  }
}

bool Journal::has_acted(const Entry& entry, std::uint64_t block) {
  return entry.before_block && *entry.before_block <= block;
}

void Journal::bring_forward(std::uint64_t block) {
  for (Entry& entry : entries) {
    if (entry.before_block) entry.before_block = std::min(*entry.before_block, block);
  }
}

// The stop belongs where the last one before it was called off.
void Journal::go_back(std::uint64_t block, std::size_t kept, const LiveCore::Moment& now) {
  const auto later = entries.begin() + static_cast<std::ptrdiff_t>(kept);
  entries.erase(std::remove_if(later, entries.end(),
                               [&](const Entry& entry) { return !has_acted(entry, block); }),
                entries.end());
  for (std::size_t i = kept; i < entries.size(); ++i) entries[i].at = now;
  bring_forward(block);
  const auto last = std::find_if(entries.rbegin(), entries.rend(),
                                 [](const Entry& entry) { return entry.last_block.has_value(); });
  if (last != entries.rend()) {
    last->last_block = block;
  } else {
    entries.insert(entries.begin(), Entry{{}, {}, {}, block});
  }
  entries.push_back({now, {}, {}, 0});
}

Replay::Replay(const Journal& journal, std::uint64_t last_block)
    : journal_(journal), last_block_(last_block), core_(std::make_unique<LiveCore>(journal.start)) {
  core_->run().set_number(journal.run);
  for (const Journal::Entry& entry : journal.entries) {
    if (entry.before_block) core_->act_before(*entry.before_block, *entry.key);
  }
  core_->stepper().count_blocks(true);
  stop_before(0);
}

void Replay::stop_before(std::uint64_t recorded) {
  const bool recorded_first = recorded != 0 && (last_block_ == 0 || recorded < last_block_);
  core_->stepper().search_block(recorded_first ? recorded : last_block_);
}

bool Replay::is_at(const LiveCore::Moment& moment) {
  if (moment.turns == LiveCore::Moment::kAllTurns || !core_->is_active())
    return core_->points() >= moment.points;
  return core_->points() > moment.points || core_->moment().turns >= moment.turns;
}

bool Replay::is_at_last_block() {
  return last_block_ != 0 && core_->stepper().blocks() >= last_block_;
}

void Replay::go_to(double time_s, const LiveCore::Moment& last) {
  for (; done_ < journal_.entries.size(); ++done_) {
    const Journal::Entry& entry = journal_.entries[done_];
    make_points(*core_, time_s, entry.at);
    if (!is_at(entry.at) || is_at_last_block()) break;
    if (entry.last_block) stop_before(*entry.last_block);
    if (entry.before_block) {
      core_->show(*entry.key);
    } else if (entry.key) {
      static_cast<void>(core_->perform(*entry.key));
    }
  }
  make_points(*core_, time_s, last);
}

}  // namespace kerf::machine
