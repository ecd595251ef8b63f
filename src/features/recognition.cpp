#include "features/recognition.hpp"

#include <algorithm>

#include "features/internal/judgement.hpp"
#include "features/internal/parents.hpp"
#include "features/internal/patterns.hpp"
#include "features/internal/visits.hpp"
#include "features/literal/literal.hpp"
#include "features/milling/milling.hpp"
#include "features/turning/turning.hpp"

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

void recognise_swept(const Recording& recording, const Blank& blank, Allowance& allowance,
                     Tree& tree) {
  if (recording.turns) {
    recognise_turning(recording, blank, allowance, tree);
  } else {
    recognise_milling(recording, blank, allowance, tree);
    find_patterns(tree);
    find_parents(tree, allowance);
  }
  tell_visits(tree);
}

}  // namespace

Tree recognise(const Recording& recording, const Blank& blank, const Asked& asked) {
  Tree tree;
  Allowance allowance(asked.bounds);
  allowance.keep(recording.bytes());
  const Method method = asked.method;
  for (const Operation& operation : operations_of(recording))
    tree.operations.push_back(facts_of(recording, operation));
  if (method != Method::swept && !recording.turns)
    tree.literal = recognise_literally(recording, allowance);
  if (method != Method::literal) recognise_swept(recording, blank, allowance, tree);
  judge(recording, blank, method, tree);
  tree.cut_short = allowance.reason();
  return tree;
}

}  // namespace kerf::features
