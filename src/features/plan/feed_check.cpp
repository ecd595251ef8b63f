#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/plan/edit_check.hpp"

namespace kerf::features {
namespace {

// Words have digits: a feed in inches is beside itself by half of its last one.
constexpr double kSameFeed = 0.02;
constexpr double kSameShare = 1e-4;

bool is_same_number(double a, double b) {
  return std::fabs(a - b) <= std::max(kSameShare * std::fabs(b), b < 10 ? 1e-4 : kSameFeed);
}

/// Feeds of cuts in their order; equal ones one behind the other are one.
class FeedRow {
 public:
  void add(double feed) {
    if (feeds_.empty() || !is_same_number(feeds_.back(), feed)) feeds_.push_back(feed);
  }
  [[nodiscard]] bool is_same(const FeedRow& other) const {
    return std::equal(feeds_.begin(), feeds_.end(), other.feeds_.begin(), other.feeds_.end(),
                      is_same_number);
  }

 private:
  std::vector<double> feeds_{};
};

void add_planned(const Recording& recording, const PlannedRow& row, FeedRow& feeds) {
  const bool cuts = row.kind == Move::Kind::feed || row.kind == Move::Kind::thread;
  if (cuts) feeds.add(row.feed.value_or(recording.state_of(recording.moves[row.like]).feed.value));
}

FeedRow planned_feeds(const Recording& recording, const RowPlan& plan) {
  FeedRow feeds;
  auto next = plan.begin();
  for (std::uint32_t row = 0; row < recording.count();) {
    if (next == plan.end() || row < next->rows.first) {
      add_planned(recording, as_it_is(recording, row++), feeds);
      continue;
    }
    for (const PlannedRow& planned : next->becomes) add_planned(recording, planned, feeds);
    row = (next++)->rows.last + 1;
  }
  return feeds;
}

FeedRow feeds_of(const Recording& recording) {
  FeedRow feeds;
  for (std::uint32_t row = 0; row < recording.count(); ++row)
    add_planned(recording, as_it_is(recording, row), feeds);
  return feeds;
}

bool has_peck(const Tree& tree, const WantedHole& wanted) {
  return std::any_of(tree.holes.begin(), tree.holes.end(), [&](const Hole& hole) {
    return geometry::length(hole.at - wanted.at) <= 2 * kSamePoint_mm &&
           std::any_of(hole.steps.begin(), hole.steps.end(), [&](const HoleStep& step) {
             return step.peck && std::fabs(*step.peck - *wanted.peck) <= kSamePoint_mm;
           });
  });
}

}  // namespace

bool has_wanted_feeds(const Recording& recording, const EditPlan& plan, const Recording& edited,
                      const Tree& after) {
  const bool are_pecks =
      std::all_of(plan.wanted_holes.begin(), plan.wanted_holes.end(),
                  [&](const WantedHole& hole) { return !hole.peck || has_peck(after, hole); });
  return are_pecks &&
         (plan.changes_more || planned_feeds(recording, plan.rows).is_same(feeds_of(edited)));
}

}  // namespace kerf::features
