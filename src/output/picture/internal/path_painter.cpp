#include "output/picture/internal/path_painter.hpp"

#include <algorithm>

#include "output/picture/drawing/palette.hpp"
#include "output/picture/internal/cut_tracer.hpp"
#include "output/picture/internal/path_tracer.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kWidest = 1.6, kThinnest = 0.5;  // pixels: lines of the cuts
constexpr double kWidestValues = 2.4;             // pixels: their colour must show
constexpr double kDense = 1.2;                    // pixels between lines: closer ones are shaded
constexpr std::size_t kMostShaded = 8;            // tools; more colours would be told apart no more

// How far lines of this length in all lie apart, in pixels. A single line is not dense.
double spacing(double length, const Box3& extents) {
  constexpr double kNarrow = 40;
  if (extents.empty() || length == 0) return kNarrow;
  return std::max(extents.size()[0], kNarrow) * std::max(extents.size()[1], kNarrow) / length;
}

double cut_spacing(const std::vector<Trail>& trails) {
  double length = 0;
  Box3 extents;
  for (const Trail& trail : trails) {
    if (trail.extents().empty()) continue;
    length += trail.length();
    extents.add(trail.extents().low());
    extents.add(trail.extents().high());
  }
  return spacing(length, extents);
}

void draw_travels(DisplayList& sheet, Trail& travels) {
  const double apart = spacing(travels.length(), travels.extents());
  const Ink ink{apart < 4 ? kFaintTravel : kTravel, std::clamp(0.08 * apart, 0.4, 0.9), true, {}};
  sheet.add(std::move(travels.outline), ink);
}

void draw_lines(DisplayList& sheet, const Subject& subject, std::vector<Trail>& cuts,
                double apart) {
  const double width = std::clamp(0.4 * apart, kThinnest, kWidest);
  for (std::size_t tool = 0; tool < cuts.size(); ++tool) {
    sheet.add(std::move(cuts[tool].outline), {subject.tool_color[tool], width, false, {}});
  }
}

// A line as wide as this leaves no gaps where a simplified path has lost lines.
double lost_width(const View& view, const Subject& subject) {
  return 2.5 * subject.tolerance * view.scale();
}

void draw_shaded(DisplayList& sheet, const View& view, const Subject& subject,
                 const Shading& shading, double apart) {
  PathTracer tracer(view, subject, &shading);
  const double width =
      std::clamp(std::max(1.2 * apart, lost_width(view, subject)), 2 * kThinnest, 2 * kWidest);
  const std::size_t per_tool = shading.layer_count() * Shading::kShades;
  for (std::size_t i = 0; i < tracer.cuts().size(); ++i) {
    const Color color = Shading::tint(subject.tool_color[i / per_tool], i % Shading::kShades);
    sheet.add(std::move(tracer.cuts()[i].outline), {color, width, false, {}});
  }
}

// In as many shades as fit: a tangle of slopes in all of them would make a picture of any size.
CutTracer trace_values(const View& view, const Subject& subject) {
  constexpr std::size_t kMostPoints = 120'000;
  std::size_t shades = CutScale::kShades;
  while (true) {
    CutTracer tracer(view, subject.values, subject.cut_scale->with_shades(shades));
    if (shades == CutScale::kFewestShades || tracer.point_count() <= kMostPoints) return tracer;
    shades = std::max(CutScale::kFewestShades, shades * 2 / 3);
  }
}

// Slow places, and burns, are small: they are painted over the others, and the smallest of them as
// dots.
void draw_values(DisplayList& sheet, const View& view, const Subject& subject, double apart) {
  constexpr double kDotsToLines = 1.9;  // widths
  CutTracer tracer = trace_values(view, subject);
  const double wanted = apart < kDense ? apart + lost_width(view, subject) : 0.4 * apart;
  const double width = std::clamp(wanted, kThinnest, kWidestValues);
  for (std::size_t shade = tracer.scale().shades(); shade-- > 0;) {
    const Color color = tracer.scale().color(shade);
    sheet.add(std::move(tracer.lines()[shade]), {color, width, false, {}});
    sheet.add(std::move(tracer.dots()[shade]), {color, kDotsToLines * width, false, {}});
  }
}

}  // namespace

Look draw_path(DisplayList& sheet, const View& view, const Subject& subject, Shading::Order order) {
  PathTracer tracer(view, subject);
  draw_travels(sheet, tracer.travels());
  const double apart = cut_spacing(tracer.cuts());
  if (subject.cut_scale) {
    draw_values(sheet, view, subject, apart);
    return Look::lines;
  }
  const bool has_form = subject.recorded.has_y() && subject.cutters.size() <= kMostShaded;
  if (apart >= kDense || !has_form) {
    draw_lines(sheet, subject, tracer.cuts(), apart);
    return Look::lines;
  }
  draw_shaded(sheet, view, subject, Shading(subject, order), apart);
  return Look::shaded;
}

}  // namespace kerf::output::plot
