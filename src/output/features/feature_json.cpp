#include "output/features/feature_json.hpp"

#include "features/tree/words.hpp"
#include "output/features/internal/feature_members.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/reports/summary.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using features::Tree;

/// Members 0 to `count`, each by its place.
template <typename Member>
std::string list_of(std::size_t count, Member&& member) {
  std::vector<std::string> items;
  items.reserve(count);
  for (std::size_t i = 0; i < count; ++i) items.push_back(member(i));
  return json_array(items);
}

std::string axis_point_json(geometry::Vec3 at) {
  JsonObject object;
  return object.raw("X", rounded(at.x)).raw("Y", rounded(at.y)).raw("Z", rounded(at.z)).done();
}

std::string blank_json(const FeatureFacts& facts) {
  if (!facts.blank) return "null";
  const stock::Bounds& box = facts.blank->extents;
  JsonObject extents;
  extents.raw("X", facts.recording->turns ? pair_json(0, 2 * box.high.x)
                                          : pair_json(box.low.x, box.high.x));
  if (!facts.recording->turns) extents.raw("Y", pair_json(box.low.y, box.high.y));
  extents.raw("Z", pair_json(box.low.z, box.high.z));
  return JsonObject()
      .text("shape", facts.blank->shape)
      .text("source", facts.blank->is_assumed ? "assumed" : "given")
      .raw("extents", extents.done())
      .done();
}

std::string setup_json(const FeatureFacts& facts, std::size_t place) {
  const features::SetUp& setup = facts.recording->setups[place];
  JsonObject object;
  object.raw("id", id_of("S", place)).text("zero", setup.zero);
  object.raw("origin", axis_point_json(setup.origin));
  return object
      .raw("axis", "[" + rounded(setup.axis.x) + "," + rounded(setup.axis.y) + "," +
                       rounded(setup.axis.z) + "]")
      .done();
}

std::string features_of_operation(const Tree& tree, std::size_t place) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < tree.features.size(); ++i) {
    for (const features::Cut& cut : tree.features[i].cuts) {
      if (cut.operation == place) ids.push_back(id_of("F", i));
    }
  }
  for (std::size_t i = 0; i < tree.holes.size(); ++i) {
    for (const features::HoleStep& step : tree.holes[i].steps) {
      if (step.operation == place) ids.push_back(id_of("H", i));
    }
  }
  return json_array(ids);
}

std::string operation_json(const FeatureFacts& facts, std::size_t place) {
  const features::OperationFacts& one = facts.tree->operations[place];
  const features::Span rows = one.visits.value_or(one.operation.rows);
  JsonObject object;
  object.raw("id", id_of("O", place)).raw("tool", rounded(one.operation.tool));
  object.raw("setup", id_of("S", one.operation.setup));
  object.raw("lines", lines_json(first_lines_of(*facts.recording, rows)));
  object.raw("spindle_rpm", rounded(one.spindle_rpm));
  object.raw("feeds", JsonObject()
                          .raw("cut", rounded_numbers_json(one.cut_feeds))
                          .raw("entry", rounded_numbers_json(one.entry_feeds))
                          .done());
  object.raw("features", features_of_operation(*facts.tree, place));
  return object.raw("cut_mm", rounded(one.cut_mm)).raw("air_mm", rounded(one.air_mm)).done();
}

std::string span_json(const FeatureFacts& facts, std::size_t place) {
  const features::Unrecognised& span = facts.tree->unrecognised[place];
  return JsonObject()
      .raw("lines", lines_json(first_lines_of(*facts.recording, span.rows)))
      .raw("moves", rounded(span.moves))
      .raw("cut_mm", rounded(span.cut_mm))
      .raw("why", word_json(word_of(span.why)))
      .done();
}

std::string disagreement_json(const FeatureFacts& facts, std::size_t place) {
  const features::Disagreement& one = facts.tree->disagreements[place];
  const features::Feature& feature = facts.tree->features[one.feature];
  JsonObject object;
  object.raw("feature", id_of("F", one.feature));
  object.raw("literal", feature.literal ? word_json(word_of(feature.literal->type)) : "null");
  return object.raw("swept", word_json(word_of(feature.type))).text("why", one.why).done();
}

std::string assumed_json(const control::Assumption& one) {
  return JsonObject().raw("line", rounded(one.line)).text("what", one.what).done();
}

}  // namespace

std::string unrecognised_json(const FeatureFacts& facts) {
  return list_of(facts.tree->unrecognised.size(),
                 [&](std::size_t i) { return span_json(facts, i); });
}

std::string features_json(const FeatureFacts& facts) {
  const Tree& tree = *facts.tree;
  JsonObject object = head_of_report(facts.run);
  object.raw("kerf", "\"features\"").raw("version", "1");
  const auto add = [&](const char* key, std::size_t count, const auto& member) {
    object.raw(key, list_of(count, [&](std::size_t i) { return member(facts, i); }));
  };
  object.raw("stock", blank_json(facts));
  add("setups", facts.recording->setups.size(), setup_json);
  add("operations", tree.operations.size(), operation_json);
  add("features", tree.features.size(), feature_json);
  add("holes", tree.holes.size(), hole_json);
  add("patterns", tree.patterns.size(), pattern_json);
  add("calls", tree.calls.size(), call_json);
  object.raw("literal", literal_json(facts));
  add("disagreements", tree.disagreements.size(), disagreement_json);
  object.raw("unrecognised", unrecognised_json(facts));
  object.raw("assumed", list_of(facts.run.assumed.size(),
                                [&](std::size_t i) { return assumed_json(facts.run.assumed[i]); }));
  return object.done() + "\n";
}

}  // namespace kerf::output
