#include "output/drawings/draw_report.hpp"

#include <cmath>
#include <map>

#include "base/decimal.hpp"
#include "output/drawings/contour_facts.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using contour::Box;

std::string number(double value) { return base::number_text(base::tidy(value)); }

std::string range(double low, double high) { return json_array({number(low), number(high)}); }

std::string truth(bool value) { return value ? "true" : "false"; }

std::string extents_json(const Box& box) {
  if (box.is_empty()) return "{}";
  return JsonObject()
      .raw("X", range(box.low.u, box.high.u))
      .raw("Y", range(box.low.v, box.high.v))
      .done();
}

std::string ignored_json(const drawing::Ignored& ignored) {
  JsonObject object;
  object.text("what", ignored.what).number("count", static_cast<double>(ignored.count));
  if (ignored.line > 0) object.number("line", ignored.line);
  return object.text("why", ignored.why).done();
}

template <typename Items, typename Write>
std::string list_json(const Items& items, const Write& write) {
  std::vector<std::string> texts;
  for (const auto& item : items) texts.push_back(write(item));
  return json_array(texts);
}

const std::string& file_name(const DrawFacts& facts, base::FileId file) {
  static const std::string none;
  const auto index = static_cast<std::size_t>(file);
  return index < facts.files.size() ? facts.files[index] : none;
}

std::string drawing_json(const DrawFacts& facts, const drawing::FileFacts& file) {
  JsonObject entities;
  for (const auto& [kind, count] : file.entities)
    entities.number(quoted(kind).substr(1, quoted(kind).size() - 2), static_cast<double>(count));
  return JsonObject()
      .text("file", file_name(facts, file.file))
      .text("format", file.format)
      .text("version", file.version)
      .text("unit", file.unit)
      .text("unit_from", file.unit_from)
      .number("scale_mm", file.scale_mm)
      .raw("entities", entities.done())
      .raw("ignored", list_json(file.ignored, ignored_json))
      .done();
}

struct LayerFacts {
  std::string colour;
  std::size_t contours = 0;
  std::size_t closed = 0;
  double length_mm = 0;
  Box box;
};

/// In the order of their first contours.
std::string layers_json(const DrawFacts& facts) {
  std::vector<std::string> order;
  std::map<std::string, LayerFacts> layers;
  const auto layer_of = [&](drawing::EntityId entity) -> LayerFacts& {
    const drawing::Entity& of = facts.drawing.entities[entity];
    const std::string name(facts.drawing.names[of.layer]);
    const auto [entry, is_new] = layers.try_emplace(name);
    if (is_new) {
      order.push_back(name);
      entry->second.colour = text_of(of.colour);
    }
    return entry->second;
  };
  for (const drawing::Chain& chain : facts.cleaned.chains) {
    LayerFacts& layer = layer_of(chain.entity);
    ++layer.contours;
    if (chain.path.is_closed) ++layer.closed;
    layer.length_mm += length(chain.path);
    layer.box.take(extents(chain.path));
  }
  for (const drawing::Point& point : facts.cleaned.points)
    layer_of(point.entity).box.take(point.at);
  return list_json(order, [&](const std::string& name) {
    const LayerFacts& layer = layers[name];
    return JsonObject()
        .text("name", name)
        .text("colour", layer.colour)
        .number("contours", static_cast<double>(layer.contours))
        .number("open", static_cast<double>(layer.contours - layer.closed))
        .number("closed", static_cast<double>(layer.closed))
        .number("length_mm", base::tidy(layer.length_mm))
        .raw("extents", extents_json(layer.box))
        .done();
  });
}

std::string contour_json(const DrawFacts& facts, std::size_t index) {
  const drawing::Chain& chain = facts.cleaned.chains[index];
  const drawing::Entity& entity = facts.drawing.entities[chain.entity];
  const drawing::Nest& nest = facts.nests[index];
  const EdgeCounts counts = edge_counts(chain.path);
  JsonObject object;
  object.text("layer", std::string(facts.drawing.names[entity.layer]))
      .text("entity", std::string(facts.drawing.names[entity.kind]))
      .number("line", entity.line);
  if (entity.handle != drawing::Name{})
    object.text("handle", std::string(facts.drawing.names[entity.handle]));
  object.raw("closed", truth(chain.path.is_closed));
  if (chain.path.is_closed)
    object.text("direction", nest.depth % 2 == 0 ? "ccw" : "cw")
        .number("depth", static_cast<double>(nest.depth))
        .number("parent", nest.parent ? static_cast<double>(*nest.parent) : -1);
  return object.number("lines", static_cast<double>(counts.lines))
      .number("arcs", static_cast<double>(counts.arcs))
      .number("length_mm", base::tidy(length(chain.path)))
      .number("area_mm2", chain.path.is_closed ? base::tidy(std::abs(area(chain.path))) : 0)
      .raw("extents", extents_json(extents(chain.path)))
      .done();
}

std::string contours_json(const DrawFacts& facts) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < facts.cleaned.chains.size(); ++i)
    texts.push_back(contour_json(facts, i));
  return json_array(texts);
}

std::string cleaned_json(const drawing::Cleaned& cleaned) {
  return JsonObject()
      .number("zero_length", static_cast<double>(cleaned.zero_length))
      .number("duplicates", static_cast<double>(cleaned.duplicates))
      .number("joined", static_cast<double>(cleaned.joined))
      .number("gaps", static_cast<double>(cleaned.gaps))
      .done();
}

std::string raster_json(const DrawFacts& facts, const process::RasterFacts& raster) {
  const drawing::Entity& entity = facts.drawing.entities[raster.entity];
  return JsonObject()
      .text("file", file_name(facts, entity.file))
      .raw("pixels", json_array({number(raster.columns), number(raster.rows)}))
      .raw("size_mm", json_array({number(raster.size_mm.u), number(raster.size_mm.v)}))
      .number("rows", static_cast<double>(raster.lines))
      .number("burnt", static_cast<double>(raster.burnt))
      .number("runs", static_cast<double>(raster.runs))
      .done();
}

std::string rasters_json(const DrawFacts& facts) {
  std::vector<std::string> texts;
  if (facts.plan == nullptr) return "[]";
  for (const process::PlannedOperation& planned : facts.plan->operations)
    for (const process::RasterFacts& raster : planned.rasters)
      texts.push_back(raster_json(facts, raster));
  return json_array(texts);
}

std::string made_extents(const process::Plan& plan, const Made& made) {
  JsonObject object;
  if (!made.has_extents) return object.done();
  for (std::size_t i = 0; i < plan.machine.axes.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    object.raw(std::string(1, plan.machine.axes[axis].letter).c_str(),
               range(made.low[axis], made.high[axis]));
  }
  return object.done();
}

std::string operation_json(const process::PlannedOperation& planned, const Made& made) {
  const process::Operation& operation = planned.operation;
  JsonObject object;
  object.text("name", operation.name)
      .text("process", process::word_of(operation.process))
      .number("contours", static_cast<double>(planned.contours))
      .number("passes", operation.passes)
      .number("lines", static_cast<double>(planned.scan_lines))
      .number("power", base::tidy(planned.settled.power_percent))
      .number("feed", base::tidy(planned.settled.feed))
      .number("beam_mm", base::tidy(made.beam_mm))
      .number("pierces", static_cast<double>(made.pierces))
      .number("beam_s", base::tidy(made.beam_s))
      .number("time_s", base::tidy(made.time_s))
      .number("energy_j", base::tidy(made.energy_j));
  if (planned.j_mm2) object.number("j_mm2", base::tidy(*planned.j_mm2));
  return object.done();
}

std::string order_json(const process::Plan& plan) {
  std::vector<std::string> contours;
  for (const process::PlannedOperation& planned : plan.operations) {
    if (planned.copy != drawing::kEveryCopy && planned.copy != 0) continue;
    for (const process::Turn& turn : planned.turns) {
      const std::uint32_t contour = planned.passes[turn.item].contour;
      if (contour != process::kNoContour) contours.push_back(number(contour));
    }
  }
  return json_array(contours);
}

/// Of all copies together.
Made made_of(const DrawFacts& facts, std::size_t index) {
  Made sum;
  for (std::size_t i = 0; i < facts.plan->operations.size(); ++i)
    if (facts.plan->operations[i].index == index) sum.add(facts.made_by_operation[i]);
  return sum;
}

std::string plan_json(const DrawFacts& facts) {
  const process::Plan& plan = *facts.plan;
  std::vector<std::string> operations;
  for (std::size_t i = 0; i < plan.operations.size(); ++i) {
    const bool is_another_copy =
        plan.operations[i].copy != drawing::kEveryCopy && plan.operations[i].copy != 0;
    if (is_another_copy) continue;
    operations.push_back(
        operation_json(plan.operations[i], made_of(facts, plan.operations[i].index)));
  }
  const Made& made = facts.made;
  // Within scans, up and down, from copy to copy: the same in any order.
  const double others = made.travel_mm - plan.travel_order_mm;
  return JsonObject()
      .text("machine", plan.machine.name)
      .raw("order", order_json(plan))
      .number("beam_mm", base::tidy(made.beam_mm))
      .number("travel_mm", base::tidy(made.travel_mm))
      .number("travel_file_mm", base::tidy(others + plan.travel_file_mm))
      .number("travel_nearest_mm", base::tidy(others + plan.travel_nearest_mm))
      .number("overscan_mm", base::tidy(made.overscan_mm))
      .number("pierces", static_cast<double>(made.pierces))
      .number("beam_s", base::tidy(made.beam_s))
      .number("time_s", base::tidy(made.time_s))
      .number("energy_j", base::tidy(made.energy_j))
      .raw("extents", made_extents(plan, made))
      .raw("operations", json_array(operations))
      .done();
}

std::string target_json(const DrawTarget& target) {
  JsonObject object;
  object.text("file", target.file).text("language", target.language);
  if (!target.flavour.empty()) object.text("flavour", target.flavour);
  return object.number("bytes", static_cast<double>(target.bytes))
      .number("deviation_mm", base::tidy(target.deviation_mm))
      .raw("lost", list_json(target.lost, quoted))
      .done();
}

std::string severity_name(base::Severity severity) {
  switch (severity) {
    case base::Severity::error: return "error";
    case base::Severity::warning: return "warning";
    case base::Severity::note: break;
  }
  return "note";
}

std::string finding_json(const DrawFacts& facts, const drawing::Finding& finding) {
  const base::Diagnostic& said = finding.diagnostic;
  JsonObject object;
  object.text("code", said.number)
      .text("severity", severity_name(said.severity))
      .text("message", said.message);
  const std::string& file = file_name(facts, said.place.file);
  if (!file.empty()) object.text("file", file);
  if (said.place.line > 0) object.number("line", said.place.line);
  if (said.place.line > 0 && said.place.column > 0) object.number("column", said.place.column);
  if (finding.layer != drawing::Name{})
    object.text("layer", std::string(facts.drawing.names[finding.layer]));
  if (finding.entity != drawing::Name{})
    object.text("entity", std::string(facts.drawing.names[finding.entity]));
  return object.done();
}

}  // namespace

std::string draw_report(const DrawFacts& facts) {
  JsonObject report;
  report
      .raw("drawings",
           list_json(facts.drawing.files,
                     [&](const drawing::FileFacts& file) { return drawing_json(facts, file); }))
      .raw("layers", layers_json(facts))
      .raw("contours", contours_json(facts))
      .raw("cleaned", cleaned_json(facts.cleaned))
      .number("error_mm", base::tidy(facts.drawing.error_mm))
      .raw("texts", list_json(facts.texts, quoted))
      .raw("rasters", rasters_json(facts));
  if (facts.plan != nullptr) report.raw("plan", plan_json(facts));
  return report.raw("targets", list_json(facts.targets, target_json))
             .raw("findings", list_json(facts.findings,
                                        [&](const drawing::Finding& finding) {
                                          return finding_json(facts, finding);
                                        }))
             .raw("assumed", list_json(facts.assumed, quoted))
             .done() +
         "\n";
}

}  // namespace kerf::output
