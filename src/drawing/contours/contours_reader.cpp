#include "drawing/contours/contours_reader.hpp"

#include <fmt/format.h>

#include "drawing/contours/internal/contours_parser.hpp"
#include "drawing/pen.hpp"
#include "drawing/units.hpp"

namespace kerf::drawing {
namespace {

constexpr std::size_t kMostOfAWord = 40;

/// Sets the unit of the file's facts; false, and told: it is none.
bool choose_unit(const ContoursFile& file, Canvas& canvas) {
  const Reading& reading = canvas.reading();
  const bool is_asked = !reading.unit.empty();
  const std::string& unit = is_asked ? reading.unit : file.unit;
  const auto mm = mm_of_unit(unit, reading.dpi > 0 ? reading.dpi : kDpi);
  FileFacts& facts = canvas.facts();
  facts.unit = mm ? unit : "mm";
  facts.unit_from = is_asked ? "--unit" : "unit";
  facts.scale_mm = mm.value_or(1);
  if (mm) return true;
  canvas.find(base::Severity::error, base::Code::contours_file, {base::kNoFile, 1, 1},
              fmt::format("its unit is '{}', and mm, cm, m, in, ft, pt, pc, px and um are known",
                          unit.size() > kMostOfAWord ? std::string("…") : unit));
  return false;
}

void draw_contour(const contour::Contour& contour, Pen& pen) {
  pen.begin(contour.vertices.front().point);
  for (std::size_t i = 1; i < contour.vertices.size(); ++i)
    pen.bulge_to(contour.vertices[i].point, contour.vertices[i - 1].bulge);
  if (!contour.is_closed || contour.vertices.size() == 1) return pen.end();
  pen.bulge_to(contour.vertices.front().point, contour.vertices.back().bulge);
  pen.close();
}

void draw_layer(const ContoursFile::Layer& layer, Canvas& canvas) {
  const double scale = canvas.facts().scale_mm;
  Entity entity;
  entity.layer = canvas.name(layer.layer.name);
  entity.kind = canvas.name("contour");
  entity.colour = layer.layer.colour;
  for (std::size_t i = 0; i < layer.lines.size() && !canvas.is_over(); ++i) {
    entity.line = layer.lines[i];
    Pen pen(canvas, canvas.add(entity), Affine::scaled(scale, scale));
    draw_contour(layer.layer.contours[i], pen);
  }
}

}  // namespace

void read_contours(const base::SourceFile& file, base::FileId id, Canvas& canvas) {
  canvas.begin_file(id, "contours");
  const ContoursFile contours = parse_contours(file);
  if (contours.fault)
    canvas.find(base::Severity::error, base::Code::contours_file, contours.fault->place,
                contours.fault->what);
  if (!choose_unit(contours, canvas)) return;
  for (const ContoursFile::Layer& layer : contours.layers)
    if (canvas.wants(layer.layer.name)) draw_layer(layer, canvas);
}

}  // namespace kerf::drawing
