#include "output/features/feature_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "features/tree/words.hpp"
#include "output/features/internal/lines.hpp"
#include "output/features/internal/text_tree.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::output {
namespace {

using features::Feature;
using features::Hole;
using features::Layer;
using features::Span;

std::string short_number(double value) { return base::rounded_text(value, 3); }

std::string lines_text(const FeatureFacts& facts, const std::vector<Span>& spans) {
  const LineRange lines = first_lines_of(*facts.recording, spans);
  return lines.first == lines.last ? fmt::format("line {}", lines.first)
                                   : fmt::format("lines {}-{}", lines.first, lines.last);
}

std::string doubts(double confidence, const std::vector<features::Reason>& reasons) {
  if (confidence >= 1 || reasons.empty()) return "";
  std::string text;
  for (const features::Reason reason : reasons)
    text += (text.empty() ? "" : ", ") + std::string(word_of(reason));
  return "  ? " + text;
}

std::string size_text(const Feature& feature) {
  const contour::Box box = contour::extents(feature.layers.front().nominal);
  if (feature.measures.round) return "Ø" + short_number(feature.measures.round->diameter);
  if (box.is_empty()) return "";
  const geometry::Vec2 size = box.high - box.low;
  return short_number(size.u) + " × " + short_number(size.v);
}

std::string passes_text(std::size_t count) {
  return count == 0 ? "" : fmt::format("  {} pass{}", count, count == 1 ? "" : "es");
}

/// The diameters that a turned contour goes through, or what else says how large a feature is.
std::string turned_text(const features::TurnedPart& part) {
  if (part.thread) {
    return fmt::format("Ø{} × {}{}{}", short_number(part.thread->major),
                       short_number(part.thread->pitch), part.thread->is_left_hand ? " left" : "",
                       passes_text(part.passes.size()));
  }
  if (part.diameter) return "Ø" + short_number(*part.diameter);
  const std::string width =
      part.width ? "width " + short_number(*part.width) + "  " : std::string();
  const contour::Box box = contour::extents(part.contour);
  if (box.is_empty()) return width;
  const std::string low = short_number(2 * box.low.v);
  const std::string high = short_number(2 * box.high.v);
  return width + "Ø" + low + (low == high ? "" : "…" + high) + passes_text(part.passes.size());
}

std::vector<Span> visits_of(const Feature& feature) {
  std::vector<Span> visits;
  for (const features::Cut& cut : feature.cuts)
    visits.insert(visits.end(), cut.visits.begin(), cut.visits.end());
  return visits;
}

std::string layer_text(const FeatureFacts& facts, const Layer& layer, std::size_t number) {
  const std::size_t loops = layer.loops.size();
  std::string text =
      fmt::format("{}  Z{}  {}", number, short_number(layer.z), lines_text(facts, layer.cuts));
  if (loops > 0) text += fmt::format("  {} loop{}", loops, loops == 1 ? "" : "s");
  return text;
}

constexpr std::size_t kMostIds = 12;  // that an operation names

/// Hangs features and holes on each other by their parents.
class TreeOfText {
 public:
  explicit TreeOfText(const FeatureFacts& facts) : facts_(facts), tree_(*facts.tree) {}

  [[nodiscard]] std::vector<TextNode> nodes() const {
    std::vector<TextNode> nodes;
    for (std::size_t i = 0; i < facts_.recording->setups.size(); ++i) {
      TextNode node{fmt::format("S{} {}", i + 1, facts_.recording->setups[i].zero)};
      for (std::size_t o = 0; o < tree_.operations.size(); ++o) {
        if (tree_.operations[o].operation.setup == i) node.below.push_back(operation(o));
      }
      nodes.push_back(std::move(node));
    }
    add_patterns(nodes);
    for (const control::Assumption& one : facts_.run.assumed) nodes.push_back({assumed_text(one)});
    add_unrecognised(nodes);
    return nodes;
  }

 private:
  [[nodiscard]] TextNode operation(std::size_t place) const {
    const features::OperationFacts& facts = tree_.operations[place];
    TextNode node{tool_text(place, facts) + later_work(place)};
    for (std::size_t i = 0; i < tree_.features.size(); ++i) {
      const Feature& feature = tree_.features[i];
      if (!feature.parent && feature.cuts.front().operation == place)
        node.below.push_back(feature_node(i));
    }
    for (std::size_t i = 0; i < tree_.holes.size(); ++i) {
      const Hole& hole = tree_.holes[i];
      if (!hole.parent && hole.steps.front().operation == place)
        node.below.push_back({hole_title(facts_, i)});
    }
    return node;
  }

  /// What an operation cuts that an earlier one has begun.
  [[nodiscard]] std::string later_work(std::size_t place) const {
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < tree_.features.size(); ++i) {
      const auto& cuts = tree_.features[i].cuts;
      const bool is_its = std::any_of(cuts.begin(), cuts.end(),
                                      [&](const auto& cut) { return cut.operation == place; });
      if (is_its && cuts.front().operation != place) ids.push_back(fmt::format("F{}", i + 1));
    }
    for (std::size_t i = 0; i < tree_.holes.size(); ++i) {
      const auto& steps = tree_.holes[i].steps;
      const bool is_its = std::any_of(steps.begin(), steps.end(),
                                      [&](const auto& step) { return step.operation == place; });
      if (is_its && steps.front().operation != place) ids.push_back(fmt::format("H{}", i + 1));
    }
    if (ids.empty()) return "";
    const bool is_long = ids.size() > kMostIds;
    if (is_long) ids.resize(kMostIds);
    return fmt::format("  goes on with {}{}", fmt::join(ids, " "), is_long ? " …" : "");
  }

  [[nodiscard]] std::string tool_text(std::size_t place,
                                      const features::OperationFacts& facts) const {
    const std::uint32_t number = facts.operation.tool;
    std::string text = fmt::format("O{} T{}", place + 1, number);
    const auto tool = facts_.recording->tools.find(number);
    if (tool != facts_.recording->tools.end()) {
      const auto diameter = tool->second.value(stock::Measure::diameter);
      if (diameter) text += " Ø" + short_number(*diameter);
      text += " " + printable(std::string(tool->second.type_name()));
    }
    if (facts.spindle_rpm > 0) text += " S" + short_number(facts.spindle_rpm);
    return text;
  }

  [[nodiscard]] TextNode feature_node(std::size_t place) const {
    const Feature& feature = tree_.features[place];
    TextNode node{feature_title(facts_, place)};
    for (std::size_t i = 0; i < feature.layers.size(); ++i)
      node.below.push_back({layer_text(facts_, feature.layers[i], i + 1)});
    for (std::size_t i = 0; i < tree_.features.size(); ++i) {
      const auto& parent = tree_.features[i].parent;
      if (parent && parent->feature == place) node.below.push_back(feature_node(i));
    }
    for (std::size_t i = 0; i < tree_.holes.size(); ++i) {
      const auto& parent = tree_.holes[i].parent;
      if (parent && parent->feature == place) node.below.push_back({hole_title(facts_, i)});
    }
    return node;
  }

  [[nodiscard]] static std::string assumed_text(const control::Assumption& one) {
    const std::string what = printable(one.what);
    return one.line == 0 ? "assumed: " + what : fmt::format("assumed: line {}: {}", one.line, what);
  }

  void add_patterns(std::vector<TextNode>& nodes) const {
    for (std::size_t i = 0; i < tree_.patterns.size(); ++i) {
      const features::Pattern& pattern = tree_.patterns[i];
      std::string text =
          fmt::format("P{} {} of {} holes: ", i + 1, word_of(pattern.kind), pattern.holes.size());
      for (const std::size_t hole : pattern.holes)
        text += fmt::format("{}H{}", hole == pattern.holes.front() ? "" : " ", hole + 1);
      nodes.push_back({text});
    }
  }

  void add_unrecognised(std::vector<TextNode>& nodes) const {
    if (tree_.unrecognised.empty()) return;
    std::string text = "not recognised:";
    for (const features::Unrecognised& span : tree_.unrecognised) {
      text +=
          fmt::format("{} {} ({} moves, {} mm, {})", &span == tree_.unrecognised.data() ? "" : ",",
                      lines_text(facts_, {span.rows}), span.moves, short_number(span.cut_mm),
                      word_of(span.why));
    }
    nodes.push_back({text});
  }

  const FeatureFacts& facts_;
  const features::Tree& tree_;
};

std::vector<TextNode> literal_nodes(const FeatureFacts& facts) {
  const features::LiteralTree& literal = facts.tree->literal;
  TextNode node{"literal: by the pattern of the rows"};
  for (const features::LiteralFeature& feature : literal.features) {
    std::string text = std::string(word_of(feature.word.type));
    if (feature.word.kind != 0) text += fmt::format(" type {}", feature.word.kind);
    text += fmt::format("  {} layer{}  {}", feature.layers.size(),
                        feature.layers.size() == 1 ? "" : "s", word_of(feature.order));
    TextNode one{text};
    for (const std::size_t place : feature.layers) {
      const features::LiteralLayer& layer = literal.layers[place];
      one.below.push_back(
          {fmt::format("Z{}  {}  {} loop{}", short_number(layer.z), lines_text(facts, {layer.rows}),
                       layer.loops.size(), layer.loops.size() == 1 ? "" : "s")});
    }
    node.below.push_back(std::move(one));
  }
  for (const features::LiteralHole& hole : literal.holes) {
    node.below.push_back({fmt::format("hole  X{} Y{}  to Z{}  line {}", short_number(hole.at.u),
                                      short_number(hole.at.v), short_number(hole.z),
                                      facts.recording->line_of(hole.row))});
  }
  return {node};
}

}  // namespace

std::string feature_title(const FeatureFacts& facts, std::size_t place) {
  const Feature& feature = facts.tree->features[place];
  std::string text = fmt::format("F{} {}", place + 1, word_of(feature.type));
  const auto add = [&](const std::string& more) {
    if (!more.empty())
      text += (text.ends_with(std::string(word_of(feature.type))) ? " " : "  ") + more;
  };
  if (!feature.layers.empty()) add(size_text(feature));
  if (feature.turned) add(turned_text(*feature.turned));
  add(fmt::format("Z{}…{}", short_number(feature.top), short_number(feature.bottom)));
  const std::size_t layers = feature.layers.size();
  if (layers > 0) add(fmt::format("{} layer{}", layers, layers == 1 ? "" : "s"));
  if (feature.order != features::Order::undefined) add(std::string(word_of(feature.order)));
  if (feature.milling != features::Milling::undefined) add(std::string(word_of(feature.milling)));
  if (layers > 0) add(fmt::format("{:.3f} mm²", feature.layers.front().area));
  add(fmt::format("{:.3f} mm³", feature.volume()));
  add(lines_text(facts, visits_of(feature)));
  return text + doubts(feature.confidence, feature.reasons);
}

std::string hole_title(const FeatureFacts& facts, std::size_t place) {
  const Hole& hole = facts.tree->holes[place];
  std::vector<Span> visits;
  for (const features::HoleStep& step : hole.steps)
    visits.insert(visits.end(), step.visits.begin(), step.visits.end());
  std::string text =
      fmt::format("H{} hole {} Ø{}  X{} Y{}  Z{}…{}{}  {:.3f} mm³  {}", place + 1,
                  word_of(hole.form), short_number(hole.diameter), short_number(hole.at.u),
                  short_number(hole.at.v), short_number(hole.top), short_number(hole.bottom),
                  hole.through ? " through" : "", hole.volume, lines_text(facts, visits));
  return text + doubts(hole.confidence, hole.reasons);
}

std::string features_text(const FeatureFacts& facts) {
  std::vector<TextNode> nodes = TreeOfText(facts).nodes();
  if (facts.method == features::Method::literal) {
    for (TextNode& node : literal_nodes(facts)) nodes.push_back(std::move(node));
  }
  return drawn(nodes);
}

}  // namespace kerf::output
