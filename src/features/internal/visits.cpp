#include "features/internal/visits.hpp"

#include <algorithm>

namespace kerf::features {
namespace {

void widen(std::optional<Span>& span, const std::vector<Span>& visits) {
  for (const Span& visit : visits) {
    if (!span) span = visit;
    span->first = std::min(span->first, visit.first);
    span->last = std::max(span->last, visit.last);
  }
}

class Trimmer {
 public:
  Trimmer(const Recording& recording, BlockReader& reader)
      : recording_(recording), reader_(reader) {}

  void trim(std::vector<Span>& visits) {
    for (Span& visit : visits) trim(visit);
  }

 private:
  // From behind the last block of the approach that sets up; rows at feed stay.
  void trim(Span& visit) {
    Span feed = visit;
    while (feed.first < feed.last && is_rapid(feed.first)) ++feed.first;
    while (feed.last > feed.first && is_rapid(feed.last)) --feed.last;
    for (std::uint32_t row = feed.first; row > visit.first; --row) {
      if (!sets_up(row - 1)) continue;
      visit.first = row;
      break;
    }
    for (std::uint32_t row = feed.last; row < visit.last; ++row) {
      if (!sets_up(row + 1)) continue;
      visit.last = row;
      break;
    }
  }

  [[nodiscard]] bool is_rapid(std::uint32_t row) const {
    return recording_.moves[row].kind == Move::Kind::rapid;
  }
  [[nodiscard]] bool sets_up(std::uint32_t row) const {
    return reader_.sets_up(recording_.block_of(recording_.moves[row]));
  }

  const Recording& recording_;
  BlockReader& reader_;
};

}  // namespace

void tell_visits(Tree& tree) {
  for (OperationFacts& operation : tree.operations) operation.visits.reset();
  for (const Feature& feature : tree.features) {
    for (const Cut& cut : feature.cuts) widen(tree.operations[cut.operation].visits, cut.visits);
  }
  for (const Hole& hole : tree.holes) {
    for (const HoleStep& step : hole.steps)
      widen(tree.operations[step.operation].visits, step.visits);
  }
}

void trim_visits(const Recording& recording, BlockReader& reader, Tree& tree) {
  Trimmer trimmer(recording, reader);
  for (Feature& feature : tree.features) {
    for (Layer& layer : feature.layers) trimmer.trim(layer.visits);
    for (Cut& cut : feature.cuts) trimmer.trim(cut.visits);
  }
  for (Hole& hole : tree.holes) {
    for (HoleStep& step : hole.steps) trimmer.trim(step.visits);
  }
  tell_visits(tree);
}

}  // namespace kerf::features
