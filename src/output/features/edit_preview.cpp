#include "output/features/edit_preview.hpp"

#include "output/features/edit_report.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

template <typename Item, typename Write>
std::string all_of(const std::vector<Item>& items, Write&& write) {
  std::vector<std::string> all;
  all.reserve(items.size());
  for (const Item& item : items) all.push_back(write(item));
  return json_array(all);
}

std::string number_or_null(const std::optional<std::size_t>& number) {
  return number ? std::to_string(*number) : "null";
}

std::string problem_json(const EditPreview::Problem& problem) {
  return JsonObject()
      .raw("edit", number_or_null(problem.edit))
      .raw("line", std::to_string(problem.line))
      .raw("column", std::to_string(problem.column))
      .text("code", problem.code)
      .text("message", problem.message)
      .text("hint", problem.hint)
      .raw("at", problem.at ? point_json(*problem.at) : "null")
      .done();
}

JsonObject at_place(const EditPreview::Place& place) {
  return JsonObject().text("feature", place.feature).raw("layer", std::to_string(place.layer));
}

std::string element_json(const EditPreview::Element& element) {
  return JsonObject()
      .raw("id", std::to_string(element.id))
      .raw("from", point_json(element.edge.from))
      .raw("to", point_json(element.edge.to))
      .raw("bulge", base::rounded_text(element.edge.bulge, 9))
      .done();
}

std::string outline_json(const EditPreview::Outline& outline) {
  return at_place(outline.of)
      .raw("island", number_or_null(outline.island))
      .raw("closed", outline.is_closed ? "true" : "false")
      .raw("elements", all_of(outline.elements, element_json))
      .done();
}

std::string paths_json(const EditPreview::Paths& paths) {
  return at_place(paths.of)
      .raw("z", rounded(paths.z))
      .raw("paths", contours_json(paths.paths))
      .done();
}

std::string areas_json(const EditPreview::Areas& areas) {
  return at_place(areas.of).raw("regions", contours_json(areas.region.loops)).done();
}

std::string member(const char* name, const std::string& json) {
  return std::string("\"") + name + "\":" + json;
}

std::string cut_members(const EditPreview::Cut& cut) {
  return "," + member("loops", all_of(cut.loops, paths_json)) + "," +
         member("added", all_of(cut.added, areas_json)) + "," +
         member("removed", all_of(cut.removed, areas_json)) + "," +
         member("rest", all_of(cut.rest, areas_json)) + "," + member("diff", text_json(cut.diff)) +
         "," + member("changes", changes_json(cut.edit)) + "," +
         member("blocks", blocks_json(cut.edit)) + "," +
         member("warnings", warnings_json(cut.edit));
}

}  // namespace

std::string edit_preview_members(const EditPreview& preview) {
  std::string text = member("problem", preview.problem ? problem_json(*preview.problem) : "null") +
                     "," + member("contours", all_of(preview.contours, outline_json));
  if (preview.cut) text += cut_members(*preview.cut);
  if (!preview.report.empty()) text += "," + member("report", preview.report);
  return text;
}

}  // namespace kerf::output
