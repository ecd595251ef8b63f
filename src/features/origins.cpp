#include "features/origins.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "features/internal/block_runs.hpp"
#include "features/internal/visits.hpp"

namespace kerf::features {
namespace {

using base::BlockId;
using Kind = Origin::Kind;

/// The blocks of something that was found, each once.
class BlocksOf {
 public:
  explicit BlocksOf(const Recording& recording) : recording_(recording) {}

  void add(const std::vector<Span>& spans) {
    for (const Span& span : spans) {
      for (std::uint32_t row = span.first; row <= span.last; ++row)
        add(recording_.moves[row].block);
    }
  }
  [[nodiscard]] const std::vector<std::uint32_t>& places() const { return places_; }

 private:
  void add(std::uint32_t block) {
    if (places_.empty() || places_.back() != block) places_.push_back(block);
  }

  const Recording& recording_;
  std::vector<std::uint32_t> places_;
};

/// What the blocks of one thing are, all together.
struct Kinds {
  bool has_expression = false;
  bool is_shared = false;
  bool is_repeated = false;
  bool is_called = false;
  bool shares_line = false;
  bool has_skipped = false;  ///< a block that a switch leaves out
  bool has_plain = false;
  std::optional<std::size_t>
      call{};  ///< the innermost one that has arguments, else that leads here
  bool has_arguments = false;
  base::FileId file = base::kNoFile;
  LineSpan lines{};
  std::optional<LineSpan> shape{};  ///< of a turning cycle
};

class OriginFinder {
 public:
  OriginFinder(const Recording& recording, BlockReader& reader, Tree& tree)
      : recording_(recording), reader_(reader), tree_(tree), runs_(recording) {}

  [[nodiscard]] Origin origin_of(const BlocksOf& blocks, bool is_list) {
    const Kinds kinds = kinds_of(blocks.places());
    Origin origin{.kind = kind_of(kinds, is_list), .call = kinds.call};
    const auto loop = origin.kind == Kind::loop ? reader_.loop_round(kinds.file, kinds.lines)
                                                : std::optional<LineSpan>{};
    if (kinds.shape) origin.shape = Span{kinds.shape->first, kinds.shape->last};
    if (loop) origin.lines = Span{loop->first, loop->last};
    return origin;
  }

 private:
  [[nodiscard]] Kinds kinds_of(const std::vector<std::uint32_t>& places) {
    Kinds kinds;
    for (const std::uint32_t place : places) look_at(place, kinds);
    // A cycle follows its shape pass by pass, which is no loop of the program.
    const bool only_text_tells = kinds.shape || (!kinds.is_repeated && kinds.has_expression);
    if (only_text_tells)
      kinds.is_repeated = reader_.loop_round(kinds.file, kinds.lines).has_value();
    return kinds;
  }

  void look_at(std::uint32_t place, Kinds& kinds) {
    const BlockId& block = recording_.blocks[place];
    const BlockFacts facts = reader_.facts(block);
    if (kinds.file == base::kNoFile) {
      kinds.file = block.file;
      kinds.lines = {block.line, block.line};
      look_at_calls(block, kinds);
    }
    if (block.file == kinds.file) {
      kinds.lines.first = std::min(kinds.lines.first, block.line);
      kinds.lines.last = std::max(kinds.lines.last, block.line);
    }
    if (facts.shape_cycle != 0 && facts.shape.first > 0 && !kinds.shape) kinds.shape = facts.shape;
    kinds.has_expression = kinds.has_expression || facts.has_expression;
    (facts.is_skipped_at_will ? kinds.has_skipped : kinds.has_plain) = true;
    kinds.shares_line = kinds.shares_line || runs_.shares_line(place);
    kinds.is_shared = kinds.is_shared || runs_.is_shared(place);
    kinds.is_repeated = kinds.is_repeated || runs_.is_repeated(place);
  }

  void look_at_calls(const BlockId& block, Kinds& kinds) {
    const std::vector<BlockId> calls = reader_.calls(block);
    kinds.is_called = !calls.empty();
    for (auto call = calls.rbegin(); call != calls.rend() && !kinds.has_arguments; ++call) {
      const std::size_t place = place_of(*call);
      const CallWords& words = tree_.calls[place].words;
      kinds.has_arguments = !words.arguments.empty();
      if (!kinds.call || kinds.has_arguments) kinds.call = place;
      kinds.is_shared = kinds.is_shared || (words.arguments.empty() && words.repeats > 1);
    }
  }

  [[nodiscard]] std::size_t place_of(const BlockId& call) {
    const auto key = std::tuple(call.file, call.from, call.calls);
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    tree_.calls.push_back(
        {.line = call.line, .column = call.column, .block = call, .words = reader_.call_of(call)});
    known_.emplace(key, tree_.calls.size() - 1);
    return tree_.calls.size() - 1;
  }

  // What a call's arguments reach counts first, then the ways to run a block more than once.
  [[nodiscard]] static Kind kind_of(const Kinds& kinds, bool is_list) {
    if (kinds.shares_line || (kinds.has_skipped && kinds.has_plain)) return Kind::mixed;
    if (kinds.has_expression && kinds.has_arguments) return Kind::expression;
    if (kinds.is_shared) return Kind::shared;
    if (kinds.is_repeated) return Kind::loop;
    if (kinds.has_expression) return Kind::expression;
    if (kinds.shape) return Kind::cycle_shape;
    if (is_list) return Kind::cycle_list;
    return kinds.is_called ? Kind::once : Kind::literal;
  }

  const Recording& recording_;
  BlockReader& reader_;
  Tree& tree_;
  BlockRuns runs_;
  std::map<std::tuple<base::FileId, std::uint64_t, base::CallPath>, std::size_t> known_;
};

Editable editable_of(const Tree& tree, const Origin& origin) {
  switch (origin.kind) {
    case Kind::shared: return Editable::shared;
    case Kind::loop: return Editable::unroll;
    case Kind::expression:
      return origin.call && !tree.calls[*origin.call].words.arguments.empty() ? Editable::argument
                                                                              : Editable::unroll;
    case Kind::mixed: return Editable::no;
    case Kind::literal:
    case Kind::once:
    case Kind::cycle_list:
    case Kind::cycle_shape: break;
  }
  return Editable::contour;
}

}  // namespace

void find_origins(const Recording& recording, BlockReader& reader, Tree& tree) {
  trim_visits(recording, reader, tree);
  OriginFinder finder(recording, reader, tree);
  for (std::size_t i = 0; i < tree.features.size(); ++i) {
    Feature& feature = tree.features[i];
    BlocksOf blocks(recording);
    for (const Layer& layer : feature.layers) blocks.add(layer.cuts);
    for (const Cut& cut : feature.cuts) {
      if (feature.turned) blocks.add(cut.visits);
    }
    feature.origin = finder.origin_of(blocks, false);
    if (feature.type != FeatureType::surface) feature.editable = editable_of(tree, feature.origin);
    if (feature.origin.call) tree.calls[*feature.origin.call].features.push_back(i);
  }
  for (std::size_t i = 0; i < tree.holes.size(); ++i) {
    Hole& hole = tree.holes[i];
    BlocksOf blocks(recording);
    bool is_list = false;
    for (const HoleStep& step : hole.steps) {
      blocks.add(step.visits);  // with the block that goes there
      is_list = is_list || step.cycle != 0;
    }
    hole.origin = finder.origin_of(blocks, is_list);
    hole.editable = editable_of(tree, hole.origin);
    if (hole.origin.call) tree.calls[*hole.origin.call].holes.push_back(i);
  }
}

}  // namespace kerf::features
