#include "features/literal/relations.hpp"
#include "features/tree/words.hpp"
#include "output/features/internal/feature_members.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using features::LiteralFeature;
using features::LiteralHole;
using features::LiteralLayer;

std::string layer_json(const FeatureFacts& facts, const LiteralLayer& layer) {
  std::vector<double> perimeters;
  std::vector<double> areas;
  for (const features::Loop& loop : layer.loops) {
    perimeters.push_back(loop.perimeter);
    areas.push_back(loop.area);
  }
  return JsonObject()
      .raw("lines", lines_json(first_lines_of(*facts.recording, layer.rows)))
      .raw("z", rounded(layer.z))
      .raw("tool", rounded(layer.tool))
      .raw("loops", rounded(static_cast<double>(layer.loops.size())))
      .raw("perimeters", rounded_numbers_json(perimeters))
      .raw("areas", rounded_numbers_json(areas))
      .done();
}

std::string feature_of_layers_json(const LiteralFeature& feature) {
  std::vector<double> layers;
  for (const std::size_t layer : feature.layers) layers.push_back(static_cast<double>(layer + 1));
  JsonObject object;
  object.raw("layers", rounded_numbers_json(layers))
      .raw("type", word_json(word_of(feature.word.type)));
  object.raw("kind", feature.word.kind == 0 ? "null" : rounded(feature.word.kind));
  return object.raw("order", word_json(word_of(feature.order))).done();
}

std::string plunge_json(const FeatureFacts& facts, const LiteralHole& hole) {
  return JsonObject()
      .raw("at", point_json(hole.at))
      .raw("z", rounded(hole.z))
      .raw("tool", rounded(hole.tool))
      .raw("line", rounded(facts.recording->line_of(hole.row)))
      .done();
}

std::string relation_json(const features::LiteralRelation& one) {
  const bool contains = one.relation == features::ScanRelation::contains;
  return JsonObject()
      .raw("features", "[" + rounded(static_cast<double>(one.first + 1)) + "," +
                           rounded(static_cast<double>(one.second + 1)) + "]")
      .text("relation", contains ? "contains" : "partial")
      .done();
}

}  // namespace

std::string literal_json(const FeatureFacts& facts) {
  const features::LiteralTree& literal = facts.tree->literal;
  std::vector<std::string> layers;
  for (const LiteralLayer& layer : literal.layers) layers.push_back(layer_json(facts, layer));
  std::vector<std::string> found;
  for (const LiteralFeature& feature : literal.features)
    found.push_back(feature_of_layers_json(feature));
  std::vector<std::string> holes;
  for (const LiteralHole& hole : literal.holes) holes.push_back(plunge_json(facts, hole));
  std::vector<std::string> relations;
  for (const features::LiteralRelation& one : features::relations_of(*facts.recording, literal))
    relations.push_back(relation_json(one));
  return JsonObject()
      .raw("layers", json_array(layers))
      .raw("features", json_array(found))
      .raw("holes", json_array(holes))
      .raw("relations", json_array(relations))
      .done();
}

}  // namespace kerf::output
