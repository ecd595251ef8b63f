// Reads a drawing and prints what came of it as JSON, one object: what the readers are compared by
// with files that other programs wrote.
//   read_drawing FILE.dxf|.json|.oma [--layer NAME]… [--unit U] [--side R|L] [--max-entities N]
//                [--quiet] [--write dxf|json|svg]: in place of what came of it, its contours
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/decimal.hpp"
#include "base/diagnostic_code.hpp"
#include "drawing/contours/contours_reader.hpp"
#include "drawing/contours/contours_writer.hpp"
#include "drawing/dxf/dxf_reader.hpp"
#include "drawing/trace/trace_reader.hpp"

namespace {

using namespace kerf;
using nlohmann::json;
using Reader = void (*)(const base::SourceFile&, base::FileId, drawing::Canvas&);

json json_of(const drawing::Affine& affine) {
  return {affine.x.u, affine.x.v, affine.y.u, affine.y.v, affine.shift.u, affine.shift.v};
}

json facts_of(const drawing::FileFacts& facts) {
  json ignored = json::object();
  for (const drawing::Ignored& what : facts.ignored) ignored[what.what] = what.count;
  return {{"format", facts.format},     {"version", facts.version},
          {"unit", facts.unit},         {"unit_from", facts.unit_from},
          {"scale_mm", facts.scale_mm}, {"entities", facts.entities},
          {"ignored", ignored}};
}

json entity_json(const drawing::Drawing& drawing, drawing::EntityId id) {
  const drawing::Entity& entity = drawing.entities[id];
  return {{"kind", drawing.names[entity.kind]},
          {"layer", drawing.names[entity.layer]},
          {"handle", drawing.names[entity.handle]},
          {"colour", text_of(entity.colour)},
          {"line", entity.line}};
}

json paths_of(const drawing::Drawing& drawing) {
  json paths = json::array();
  for (const drawing::Path& path : drawing.paths) {
    json vertices = json::array();
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      const contour::Vertex& vertex = drawing.vertices[i];
      vertices.push_back({vertex.point.u, vertex.point.v, vertex.bulge});
    }
    json one = entity_json(drawing, drawing.vertices[path.first].owner);
    one["closed"] = path.is_closed;
    one["vertices"] = std::move(vertices);
    paths.push_back(std::move(one));
  }
  return paths;
}

json texts_of(const drawing::Drawing& drawing) {
  json texts = json::array();
  for (const drawing::Text& text : drawing.texts) {
    json one = entity_json(drawing, text.entity);
    one["words"] = text.words;
    one["to_mm"] = json_of(text.to_mm);
    one["height"] = text.height;
    one["width"] = text.width;
    one["stretch"] = text.stretch;
    one["across"] = static_cast<int>(text.across);
    one["upright"] = static_cast<int>(text.upright);
    texts.push_back(std::move(one));
  }
  return texts;
}

json points_of(const drawing::Drawing& drawing) {
  json points = json::array();
  for (const drawing::Point& point : drawing.points) {
    json one = entity_json(drawing, point.entity);
    one["at"] = {point.at.u, point.at.v};
    points.push_back(std::move(one));
  }
  return points;
}

json findings_of(const drawing::Drawing& drawing) {
  json findings = json::array();
  for (const drawing::Finding& finding : drawing.findings) {
    findings.push_back({{"code", finding.diagnostic.number},
                        {"severity", static_cast<int>(finding.diagnostic.severity)},
                        {"line", finding.diagnostic.place.line},
                        {"message", finding.diagnostic.message}});
  }
  return findings;
}

json json_of(const drawing::Drawing& drawing) {
  json files = json::array();
  for (const drawing::FileFacts& facts : drawing.files) files.push_back(facts_of(facts));
  return {{"files", files},
          {"paths", paths_of(drawing)},
          {"points", points_of(drawing)},
          {"texts", texts_of(drawing)},
          {"findings", findings_of(drawing)},
          {"error_mm", drawing.error_mm}};
}

void print_counts(const drawing::Drawing& drawing) {
  std::printf("%zu entities, %zu vertices, %zu findings\n", drawing.entities.size(),
              drawing.vertices.size(), drawing.findings.size());
}

std::vector<drawing::ContourLayer> layers_of(const drawing::Drawing& drawing) {
  std::vector<drawing::ContourLayer> layers;
  const auto layer_of = [&](const drawing::Entity& entity) -> drawing::ContourLayer& {
    const std::string name(drawing.names[entity.layer]);
    for (drawing::ContourLayer& layer : layers)
      if (layer.name == name) return layer;
    layers.push_back({name, entity.colour, {}});
    return layers.back();
  };
  for (const drawing::Path& path : drawing.paths)
    layer_of(drawing.entities[drawing.vertices[path.first].owner])
        .contours.push_back(contour_of(drawing, path));
  return layers;
}

void print_contours(const drawing::Drawing& drawing, std::string_view format) {
  const auto print = [](std::string_view piece) {
    std::fwrite(piece.data(), 1, piece.size(), stdout);
  };
  const std::vector<drawing::ContourLayer> layers = layers_of(drawing);
  if (format == "json") drawing::write_contours_json(layers, print);
  if (format == "dxf") drawing::write_contours_dxf(layers, print);
  if (format == "svg") drawing::write_contours_svg(layers, print);
}

Reader reader_of(std::string_view path) {
  if (path.ends_with(".json")) return drawing::read_contours;
  if (path.ends_with(".oma")) return drawing::read_trace;
  return drawing::read_dxf;
}

}  // namespace

int main(int count, char** words) {
  drawing::Reading reading;
  std::string path;
  std::string format;
  bool quiet = false;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    const bool has_value = i + 1 < count;
    if (word == "--quiet")
      quiet = true;
    else if (word == "--layer" && has_value)
      reading.layers.emplace_back(words[++i]);
    else if (word == "--side" && has_value)
      reading.lens_side = words[++i][0];
    else if (word == "--write" && has_value)
      format = words[++i];
    else if (word == "--unit" && has_value)
      reading.unit = words[++i];
    else if (word == "--max-entities" && has_value)
      reading.max_entities = base::read_whole_number(words[++i]).value_or(0);
    else
      path = word;
  }
  const auto file = base::SourceFile::open(path);
  if (!file) {
    std::fprintf(stderr, "%s\n", file.error().message.c_str());
    return EXIT_FAILURE;
  }
  drawing::Drawing drawing;
  drawing::Canvas canvas(reading, drawing);
  reader_of(path)(**file, base::FileId{0}, canvas);
  if (!format.empty())
    print_contours(drawing, format);
  else if (quiet)
    print_counts(drawing);
  else
    std::printf("%s\n", json_of(drawing).dump().c_str());
  return EXIT_SUCCESS;
}
