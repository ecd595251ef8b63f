#include "features/tree/words.hpp"
#include "output/features/internal/feature_members.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/features/internal/turned_json.hpp"
#include "output/writing/json_object.hpp"
#include "output/writing/title.hpp"

namespace kerf::output {
namespace {

using features::Cut;
using features::Feature;
using features::FeatureMeasures;
using features::Layer;
using features::Loop;
using features::Span;

std::string file_of(const FeatureFacts& facts, base::FileId file) {
  return facts.sources->contains(file) ? file_title((*facts.sources)[file].name()) : "";
}

std::string entry_json(const features::Entry& entry) {
  return JsonObject()
      .raw("kind", word_json(word_of(entry.kind)))
      .raw("lead", word_json(word_of(entry.lead)))
      .raw("pitch", rounded_or_null(entry.pitch))
      .done();
}

std::string program_word(base::ProgramNumber number) {
  std::string digits = std::to_string(static_cast<std::uint32_t>(number));
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return "O" + digits;
}

std::string blocks_json(const FeatureFacts& facts, const std::vector<Span>& spans) {
  std::vector<std::string> items;
  for (const LineRange& range : lines_of(*facts.recording, spans)) {
    items.push_back(JsonObject()
                        .text("file", file_of(facts, range.file))
                        .text("program", program_word(range.program))
                        .raw("first", rounded(range.first))
                        .raw("last", rounded(range.last))
                        .done());
  }
  return json_array(items);
}

std::string loop_json(const FeatureFacts& facts, const Loop& loop) {
  return JsonObject()
      .raw("lines", lines_json(first_lines_of(*facts.recording, loop.rows)))
      .raw("perimeter", rounded(loop.perimeter))
      .raw("area", rounded(loop.area))
      .raw("contour",
           facts.tells_loops ? contour_json(facts.recording->contour_of(loop.rows)) : "[]")
      .done();
}

std::string links_json(const FeatureFacts& facts, const Layer& layer) {
  std::vector<std::string> items;
  for (const std::uint32_t row : layer.links)
    items.push_back(lines_json(first_lines_of(*facts.recording, Span{row, row})));
  return json_array(items);
}

std::string loops_json(const FeatureFacts& facts, const Layer& layer) {
  std::vector<std::string> items;
  for (const Loop& loop : layer.loops) items.push_back(loop_json(facts, loop));
  return json_array(items);
}

std::string frame_json(const features::Frame& frame) {
  return JsonObject()
      .raw("rotation_deg", rounded(frame.rotation_deg))
      .raw("scale", rounded(frame.scale))
      .raw("mirror", frame.mirror ? "true" : "false")
      .done();
}

std::string layer_json(const FeatureFacts& facts, const Layer& layer, std::size_t number) {
  const Span rows = rows_of(*facts.recording, layer.cuts);
  JsonObject object;
  object.raw("n", rounded(static_cast<double>(number))).raw("z", rounded(layer.z));
  object.raw("top", rounded(layer.top)).raw("lines", lines_json(facts, layer.cuts));
  object.raw("rows", pair_json(rows.first, rows.last));
  object.raw("blocks", blocks_json(facts, layer.cuts));
  object.raw("visit", lines_json(facts, layer.visits)).raw("frame", frame_json(layer.frame));
  object.raw("area", rounded(layer.area)).raw("volume_mm3", rounded(layer.volume()));
  object.raw("contour", contour_json(layer.contour)).raw("islands", contours_json(layer.islands));
  object.raw("nominal", contour_json(layer.nominal));
  object.raw("nominal_islands", contours_json(layer.nominal_islands));
  object.raw("loops", loops_json(facts, layer)).raw("links", links_json(facts, layer));
  return object.raw("entry", entry_json(layer.entry)).done();
}

std::string cut_json(const FeatureFacts& facts, const Cut& cut) {
  return JsonObject()
      .raw("operation", id_of("O", cut.operation))
      .raw("tool", rounded(facts.tree->operations[cut.operation].operation.tool))
      .raw("role", word_json(word_of(cut.role)))
      .raw("lines", lines_json(facts, cut.visits))
      .done();
}

std::string compensated_json(features::Compensation compensation) {
  if (compensation == features::Compensation::left) return "\"G41\"";
  return compensation == features::Compensation::right ? "\"G42\"" : "null";
}

std::string literal_word_json(const Feature& feature) {
  if (!feature.literal) return "null";
  JsonObject object;
  object.raw("type", word_json(word_of(feature.literal->type)));
  if (feature.literal->kind != 0) object.raw("kind", rounded(feature.literal->kind));
  return object.done();
}

void add_region(const Layer& top, JsonObject& object) {
  const contour::Box box = contour::extents(top.contour);
  const bool is_empty = box.is_empty();
  object.raw("area", rounded(top.area));
  object.raw("size", is_empty ? "[0,0]" : point_json(box.high - box.low));
  object.raw("center", is_empty ? "null" : point_json(box.middle()));
  object.raw("contour", contour_json(top.contour)).raw("islands", contours_json(top.islands));
  object.raw("nominal", contour_json(top.nominal));
  object.raw("nominal_islands", contours_json(top.nominal_islands));
}

void add_measures(const FeatureMeasures& measures, JsonObject& object) {
  if (measures.round) {
    object.raw("round", JsonObject()
                            .raw("diameter", rounded(measures.round->diameter))
                            .raw("center", point_json(measures.round->centre))
                            .done());
  }
  if (measures.width) object.raw("width", rounded(*measures.width));
  if (measures.length) object.raw("length", rounded(*measures.length));
  if (measures.open_ends) object.raw("open_ends", rounded(*measures.open_ends));
  if (measures.wall_share) object.raw("wall_share", rounded(*measures.wall_share));
  if (measures.draft_deg) object.raw("draft_deg", rounded(*measures.draft_deg));
  if (!measures.strokes.empty()) object.raw("strokes", contours_json(measures.strokes));
  if (measures.centre_line) object.raw("center_line", contour_json(*measures.centre_line));
}

void add_strategy(const Feature& feature, JsonObject& object) {
  object.raw("order", word_json(word_of(feature.order)));
  object.raw("strategy", word_json(word_of(feature.strategy)));
  object.raw("stepover", rounded_or_null(feature.stepover));
  object.raw("stepdown", rounded_or_null(feature.stepdown));
  object.raw("direction", feature.milling == features::Milling::undefined
                              ? "null"
                              : word_json(word_of(feature.milling)));
  object.raw("entry", entry_json(feature.entry));
}

void add_judgement(const Feature& feature, JsonObject& object) {
  object.raw("compensated", compensated_json(feature.compensated));
  object.raw("origin", origin_json(feature.origin));
  object.raw("editable", word_json(word_of(feature.editable)));
  object.raw("confidence", rounded(feature.confidence));
  object.raw("reasons", reasons_json(feature.reasons));
  object.raw("literal", literal_word_json(feature));
  object.raw("swept", JsonObject().raw("type", word_json(word_of(feature.type))).done());
  object.raw("agree", feature.agree ? "true" : "false");
}

}  // namespace

std::string word_json(std::string_view word) { return '"' + std::string(word) + '"'; }

std::string lines_json(const FeatureFacts& facts, const std::vector<Span>& spans) {
  return lines_json(first_lines_of(*facts.recording, spans));
}

std::string parent_json(const std::optional<features::Relation>& parent) {
  if (!parent) return "null";
  return JsonObject()
      .raw("id", id_of("F", parent->feature))
      .raw("relation", word_json(word_of(parent->kind)))
      .done();
}

std::string origin_json(const features::Origin& origin) {
  const auto range = [](const std::optional<Span>& lines) {
    return lines ? pair_json(lines->first, lines->last) : std::string("null");
  };
  JsonObject object;
  object.raw("kind", word_json(word_of(origin.kind))).raw("lines", range(origin.lines));
  object.raw("call", origin.call ? id_of("C", *origin.call) : "null");
  if (origin.shape) object.raw("shape", range(origin.shape));
  return object.done();
}

std::string reasons_json(const std::vector<features::Reason>& reasons) {
  std::vector<std::string> items;
  for (const features::Reason reason : reasons) items.push_back(word_json(word_of(reason)));
  return json_array(items);
}

std::string feature_json(const FeatureFacts& facts, std::size_t place) {
  const Feature& feature = facts.tree->features[place];
  JsonObject object;
  object.raw("id", id_of("F", place)).text("key", feature.key);
  object.raw("type", word_json(word_of(feature.type))).raw("setup", id_of("S", feature.setup));
  object.raw("tool", rounded(feature.tool)).raw("parent", parent_json(feature.parent));
  object.raw("z", pair_json(feature.top, feature.bottom)).raw("depth", rounded(feature.depth()));
  object.raw("through", feature.through ? "true" : "false");
  object.raw("volume_mm3", rounded(feature.volume()));
  if (feature.turned) {
    add_turned(facts, feature, object);
  } else {
    add_region(feature.layers.empty() ? Layer{} : feature.layers.front(), object);
  }
  add_measures(feature.measures, object);
  add_strategy(feature, object);
  std::vector<std::string> cuts;
  for (const Cut& cut : feature.cuts) cuts.push_back(cut_json(facts, cut));
  object.raw("cuts", json_array(cuts));
  std::vector<std::string> layers;
  for (std::size_t i = 0; i < feature.layers.size(); ++i)
    layers.push_back(layer_json(facts, feature.layers[i], i + 1));
  object.raw("layers", json_array(layers));
  add_judgement(feature, object);
  return object.done();
}

}  // namespace kerf::output
