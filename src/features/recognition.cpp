#include "features/recognition.hpp"

#include <algorithm>

#include "features/literal/literal.hpp"

namespace kerf::features {
namespace {

void note_feed(std::vector<double>& feeds, double feed) {
  if (feed > 0 && std::find(feeds.begin(), feeds.end(), feed) == feeds.end()) feeds.push_back(feed);
}

OperationFacts facts_of(const Recording& recording, const Operation& operation) {
  OperationFacts facts{.operation = operation};
  for (std::uint32_t row = operation.rows.first; row <= operation.rows.last; ++row) {
    const Move& move = recording.moves[row];
    if (move.kind == Move::Kind::rapid) continue;
    const State& state = recording.state_of(move);
    facts.cut_mm += recording.length_of(row);
    if (facts.spindle_rpm == 0) facts.spindle_rpm = state.spindle_rpm;
    note_feed(recording.goes_across(row) ? facts.cut_feeds : facts.entry_feeds, state.feed.value);
  }
  return facts;
}

}  // namespace

Tree recognise(const Recording& recording) {
  Tree tree;
  for (const Operation& operation : operations_of(recording))
    tree.operations.push_back(facts_of(recording, operation));
  if (!recording.turns) tree.literal = recognise_literally(recording);
  return tree;
}

}  // namespace kerf::features
