#include "features/internal/judgement.hpp"

#include <algorithm>
#include <string>

#include "features/tree/words.hpp"

namespace kerf::features {
namespace {

constexpr double kToolAssumed = 0.5;
constexpr double kStockAssumed = 0.6;
constexpr double kRingByDefault = 0.6;
constexpr double kMethodsDiffer = 0.7;
constexpr double kAdaptive = 0.8;
constexpr double kSurface = 0.9;

/// Finds the literal feature that has a row.
class LiteralIndex {
 public:
  explicit LiteralIndex(const LiteralTree& literal)
      : literal_(literal), feature_of_(literal.layers.size()) {
    for (const LiteralFeature& feature : literal.features) {
      for (const std::size_t layer : feature.layers) feature_of_[layer] = &feature;
    }
  }

  [[nodiscard]] std::optional<LiteralWord> word_at(std::uint32_t row) const {
    const auto behind = std::upper_bound(
        literal_.layers.begin(), literal_.layers.end(), row,
        [](std::uint32_t one, const LiteralLayer& layer) { return one < layer.rows.first; });
    if (behind == literal_.layers.begin() || (behind - 1)->rows.last < row) return std::nullopt;
    const auto place = static_cast<std::size_t>(behind - 1 - literal_.layers.begin());
    if (feature_of_[place] == nullptr) return std::nullopt;
    return feature_of_[place]->word;
  }

 private:
  const LiteralTree& literal_;
  std::vector<const LiteralFeature*> feature_of_;
};

bool is_one_of(FeatureType type, std::initializer_list<FeatureType> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

bool agree(const Feature& feature) {
  if (!feature.literal) return feature.layers.empty() || feature.layers.front().loops.empty();
  using Type = FeatureType;
  if (feature.literal->type == LiteralWord::Type::pocket)
    return is_one_of(feature.type, {Type::pocket, Type::face, Type::slot});
  return is_one_of(feature.type, {Type::outside_profile, Type::inside_profile, Type::boss});
}

std::string why(const Feature& feature) {
  const std::string swept(word_of(feature.type));
  if (!feature.literal)
    return "its loops belong to no layer of the rows; what is swept is a " + swept;
  if (feature.literal->type == LiteralWord::Type::pocket)
    return "nothing is left inside the smallest loop, and what is swept is a " + swept;
  return "something is left inside the smallest loop, and what is swept is a " + swept;
}

bool depends_on_blank(FeatureType type) {
  using Type = FeatureType;
  return is_one_of(type, {Type::pocket, Type::face, Type::boss, Type::step, Type::open_pocket});
}

template <typename Found>
void doubt(Found& found, Reason reason, double confidence) {
  found.reasons.push_back(reason);
  found.confidence = std::min(found.confidence, confidence);
}

bool is_assumed(const Recording& recording, std::uint32_t tool) {
  const auto known = recording.tools.find(tool);
  return known == recording.tools.end() || known->second.source == stock::ToolSource::assumed;
}

void judge_feature(const Recording& recording, const Blank& blank, Feature& feature) {
  const std::vector<Reason> found = std::move(feature.reasons);
  feature.reasons.clear();
  if (is_assumed(recording, feature.tool)) doubt(feature, Reason::tool_assumed, kToolAssumed);
  if (!blank.is_known && depends_on_blank(feature.type))
    doubt(feature, Reason::stock_assumed, kStockAssumed);
  for (const Reason reason : found)
    doubt(feature, reason, reason == Reason::ring_by_default ? kRingByDefault : 1);
  if (!feature.agree) doubt(feature, Reason::methods_differ, kMethodsDiffer);
  if (feature.strategy == Strategy::adaptive) doubt(feature, Reason::adaptive, kAdaptive);
  if (feature.type == FeatureType::surface) doubt(feature, Reason::surface, kSurface);
  const bool has_idle_layer =
      std::any_of(feature.layers.begin(), feature.layers.end(),
                  [](const Layer& layer) { return layer.removed.is_empty(); });
  if (has_idle_layer && has_levels(feature.type) && !feature.turned)
    doubt(feature, Reason::no_material, 1);
  if (feature.entry.kind == Entry::Kind::rapid) doubt(feature, Reason::entered_by_rapid, 1);
}

}  // namespace

void judge(const Recording& recording, const Blank& blank, Method method, Tree& tree) {
  const LiteralIndex index(tree.literal);
  for (std::size_t i = 0; i < tree.features.size(); ++i) {
    Feature& feature = tree.features[i];
    const bool has_both = method == Method::both && has_levels(feature.type);
    if (has_both && !feature.turned && !feature.layers.empty() &&
        !feature.layers.front().cuts.empty()) {
      feature.literal = index.word_at(feature.layers.front().cuts.front().first);
      feature.agree = agree(feature);
    }
    if (!feature.agree) tree.disagreements.push_back({i, why(feature)});
    judge_feature(recording, blank, feature);
    if (feature.type == FeatureType::surface) feature.editable = Editable::no;
  }
  for (Hole& hole : tree.holes) {
    for (const HoleStep& step : hole.steps) {
      if (!is_assumed(recording, step.tool)) continue;
      doubt(hole, Reason::tool_assumed, kToolAssumed);
      break;
    }
  }
}

}  // namespace kerf::features
