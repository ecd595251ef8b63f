#include "features/tree/words.hpp"
#include "output/features/internal/feature_members.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using features::Hole;
using features::HoleStep;
using features::Pattern;

std::string cycle_json(std::uint16_t cycle) {
  return cycle == 0 ? "null" : word_json("G" + std::to_string(cycle));
}

std::string steps_json(const FeatureFacts& facts, const Hole& hole) {
  std::vector<std::string> items;
  for (const HoleStep& step : hole.steps) items.push_back(step_json(facts, step));
  return json_array(items);
}

std::string thread_json(const Hole& hole) {
  if (!hole.thread) return "null";
  return JsonObject()
      .raw("pitch", rounded(hole.thread->pitch))
      .raw("diameter", rounded(hole.thread->diameter))
      .done();
}

}  // namespace

std::string step_json(const FeatureFacts& facts, const HoleStep& step) {
  return JsonObject()
      .raw("how", word_json(word_of(step.how)))
      .raw("tool", rounded(step.tool))
      .raw("diameter", rounded(step.diameter))
      .raw("z", pair_json(step.top, step.bottom))
      .raw("cycle", cycle_json(step.cycle))
      .raw("peck", rounded_or_null(step.peck))
      .raw("lines", lines_json(facts, step.visits))
      .done();
}

std::string hole_json(const FeatureFacts& facts, std::size_t place) {
  const Hole& hole = facts.tree->holes[place];
  JsonObject object;
  object.raw("id", id_of("H", place)).text("key", hole.key).raw("type", "\"hole\"");
  object.raw("form", word_json(word_of(hole.form))).raw("setup", id_of("S", hole.setup));
  object.raw("tool", rounded(hole.tool)).raw("parent", parent_json(hole.parent));
  object.raw("at", point_json(hole.at)).raw("diameter", rounded(hole.diameter));
  object.raw("z", pair_json(hole.top, hole.bottom)).raw("depth", rounded(hole.top - hole.bottom));
  object.raw("through", hole.through ? "true" : "false");
  object.raw("volume_mm3", rounded(hole.volume));
  object.raw("pattern", hole.pattern ? id_of("P", *hole.pattern) : "null");
  object.raw("thread", thread_json(hole)).raw("steps", steps_json(facts, hole));
  object.raw("origin", origin_json(hole.origin));
  object.raw("editable", word_json(word_of(hole.editable)));
  object.raw("confidence", rounded(hole.confidence));
  return object.raw("reasons", reasons_json(hole.reasons)).done();
}

std::string pattern_json(const FeatureFacts& facts, std::size_t place) {
  const Pattern& pattern = facts.tree->patterns[place];
  std::vector<std::string> holes;
  for (const std::size_t hole : pattern.holes) holes.push_back(id_of("H", hole));
  JsonObject object;
  object.raw("id", id_of("P", place)).raw("kind", word_json(word_of(pattern.kind)));
  object.raw("holes", json_array(holes));
  object.raw("count", rounded(static_cast<double>(pattern.holes.size())));
  if (pattern.pitch && pattern.second_pitch) {
    object.raw("pitch", pair_json(*pattern.pitch, *pattern.second_pitch));
  } else if (pattern.pitch) {
    object.raw("pitch", rounded(*pattern.pitch));
  }
  if (pattern.angle_deg) object.raw("angle_deg", rounded(*pattern.angle_deg));
  if (pattern.centre) object.raw("center", point_json(*pattern.centre));
  if (pattern.radius) object.raw("radius", rounded(*pattern.radius));
  if (pattern.start_deg) object.raw("start_deg", rounded(*pattern.start_deg));
  return object.done();
}

}  // namespace kerf::output
