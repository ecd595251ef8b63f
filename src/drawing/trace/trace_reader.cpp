#include "drawing/trace/trace_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/decimal.hpp"
#include "base/text_window.hpp"
#include "drawing/cubic_spline.hpp"
#include "drawing/pen.hpp"
#include "drawing/trace/internal/trace.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::drawing {
namespace trace {
namespace {

using base::Code;
using base::Severity;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kUnit_mm = 0.01;
constexpr double kUnit_rad = 0.01 * std::numbers::pi / 180;

/// Radii at ascending angles, and once more the first angle a turn later.
struct Ring {
  std::vector<double> radii;   // mm
  std::vector<double> angles;  // rad
};

base::Place line_of(std::uint32_t line) { return {base::kNoFile, line, 1}; }

void tell_count(const Trace& trace, const std::string& why, Canvas& canvas) {
  canvas.find(Severity::error, Code::trace_count, line_of(trace.line), why, canvas.name(kLensLayer),
              canvas.name("trace"));
}

Records records_of(const base::SourceFile& file, base::FileId id) {
  base::TextWindow window;
  window.stand_at(file, id, 0, file.size());
  Records records;
  base::TextWindow::Line line;
  for (std::uint32_t number = 1; window.next(line); ++number) {
    const Entry entry = entry_of(line.text, number);
    if (!entry.label.empty()) records.take(entry);
  }
  return records;
}

/// The one that is drawn; null: there is none.
const Trace* chosen(const Records& records, char side) {
  const std::vector<Trace>& traces = records.traces;
  if (traces.empty()) return nullptr;
  const auto wanted = std::find_if(traces.begin(), traces.end(), [side](const Trace& trace) {
    return side == 0 || trace.side == side;
  });
  return wanted == traces.end() ? &traces.front() : &*wanted;
}

bool is_of_known_format(const Trace& trace, Canvas& canvas) {
  if (trace.format == "1") return true;
  const std::string what = trace.format.empty()
                               ? std::string("TRCFMT says none")
                               : fmt::format("TRCFMT says format {}", trace.format.substr(0, 20));
  canvas.find(Severity::error, Code::trace_format, line_of(trace.line), what,
              canvas.name(kLensLayer), canvas.name("trace"));
  return false;
}

/// Told where it is wrong.
bool counts_up(const Trace& trace, Canvas& canvas) {
  constexpr std::uint64_t kLeast = 3;
  constexpr std::uint64_t kMost = 10'000;
  const std::uint64_t count = base::read_whole_number(trace.count).value_or(0);
  if (count < kLeast || count > kMost)
    tell_count(trace,
               fmt::format("TRCFMT says {} radii, and {} to {} make a curve",
                           trace.count.substr(0, 20), kLeast, kMost),
               canvas);
  else if (!trace.is_readable)
    tell_count(trace, "one of the radii or angles is no number", canvas);
  else if (trace.radii.size() != count)
    tell_count(trace, fmt::format("{} radii where TRCFMT says {}", trace.radii.size(), count),
               canvas);
  else if (trace.has_angles && trace.angles.size() != count)
    tell_count(trace, fmt::format("{} angles where TRCFMT says {}", trace.angles.size(), count),
               canvas);
  else
    return true;
  return false;
}

/// The trace with X mirrored: angles go the other way from half a turn.
void mirror(Ring& ring) {
  const std::size_t count = ring.radii.size();
  std::reverse(ring.radii.begin(), ring.radii.end());
  std::vector<double> angles(count + 1);
  for (std::size_t i = 0; i < count; ++i) angles[i] = std::numbers::pi - ring.angles[count - 1 - i];
  angles[count] = angles[0] + kTurn;
  ring.angles = std::move(angles);
}

std::optional<Ring> ring_of(const Trace& trace, Canvas& canvas) {
  Ring ring;
  const std::size_t count = trace.radii.size();
  for (std::size_t i = 0; i < count; ++i) {
    ring.radii.push_back(kUnit_mm * trace.radii[i]);
    const double share = static_cast<double>(i) / static_cast<double>(count);
    ring.angles.push_back(trace.has_angles ? kUnit_rad * trace.angles[i] : kTurn * share);
  }
  ring.angles.push_back(ring.angles[0] + kTurn);
  const bool is_outside = std::all_of(ring.radii.begin(), ring.radii.end(),
                                      [](double radius) { return radius > 0 && radius < 1e4; });
  if (!is_outside) {
    tell_count(trace, "a radius is not above 0, or above 10,000 mm", canvas);
    return std::nullopt;
  }
  const bool descends = std::adjacent_find(ring.angles.begin(), ring.angles.end(),
                                           std::greater_equal<>()) != ring.angles.end();
  const bool is_near = std::abs(ring.angles[0]) <= kTurn;
  if (!descends && is_near) return ring;
  tell_count(trace, "the angles do not ascend once round", canvas);
  return std::nullopt;
}

std::vector<Polar> curves_through(const Ring& ring) {
  const std::vector<double> slopes = periodic_slopes(ring.angles, ring.radii);
  std::vector<Polar> curves;
  const std::size_t count = ring.radii.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double third = (ring.angles[i + 1] - ring.angles[i]) / 3;
    curves.push_back({{ring.radii[i], ring.radii[i] + third * slopes[i],
                       ring.radii[next] - third * slopes[next], ring.radii[next]},
                      ring.angles[i],
                      ring.angles[i + 1]});
  }
  return curves;
}

void draw_ring(const std::vector<Polar>& curves, const Trace& trace, Canvas& canvas) {
  Entity entity;
  entity.line = trace.line;
  entity.layer = canvas.name(kLensLayer);
  entity.kind = canvas.name("trace");
  Pen pen(canvas, canvas.add(entity), {});
  pen.begin(curves.back().end());
  for (const Polar& curve : curves) {
    if (canvas.is_over()) return;
    pen.polar_to(curve);
  }
  pen.close();
}

contour::Box box_of(const std::vector<Polar>& curves) {
  std::vector<Step> steps;
  Fit fit{steps, 0.001, 0};
  for (const Polar& curve : curves) fit_polar(curve, fit);
  contour::Contour contour{{{curves.back().end()}}, false};
  for (const Step& step : steps) {
    contour.vertices.back().bulge = step.bulge;
    contour.vertices.push_back({step.to});
  }
  return extents(contour);
}

/// The value of HBOX or VBOX for a side: the first of two is that of the right one.
std::optional<double> said_of(const Entry& box, char side) {
  const std::vector<std::string_view> fields = parted(box.value);
  const std::size_t which = side == 'L' && fields.size() > 1 ? 1 : 0;
  const auto value = base::read_number(fields[which]);
  return value ? std::optional(*value) : std::nullopt;
}

void check_boxes(const Records& records, const Trace& trace, const std::vector<Polar>& curves,
                 Canvas& canvas) {
  constexpr double kMost_mm = 0.2;
  if (records.boxes.empty()) return;
  const contour::Box box = box_of(curves);
  for (const Entry& entry : records.boxes) {
    const double is = entry.label == "HBOX" ? box.high.u - box.low.u : box.high.v - box.low.v;
    const auto said = said_of(entry, trace.side);
    if (!said || std::abs(*said - is) <= kMost_mm) continue;
    canvas.find(Severity::warning, Code::trace_box, line_of(entry.line),
                fmt::format("{} says {} mm, and the curve has {}", entry.label,
                            base::number_text(*said), base::rounded_text(is, 3)),
                canvas.name(kLensLayer), canvas.name("trace"));
  }
}

void ignore_rest(const Records& records, const Trace& drawn, Canvas& canvas) {
  for (const Entry& entry : records.unmade)
    canvas.ignore(entry.label.starts_with("BEV") ? "bevel" : "holes", entry.line,
                  "the outline alone is cut");
  for (const Trace& trace : records.traces)
    if (&trace != &drawn)
      canvas.ignore("another trace", trace.line, "one side is drawn: lens.side says which");
}

void draw(const Records& records, const Trace& trace, Canvas& canvas) {
  if (!is_of_known_format(trace, canvas) || !counts_up(trace, canvas)) return;
  auto ring = ring_of(trace, canvas);
  if (!ring) return;
  const char side = canvas.reading().lens_side;
  const bool is_other = (side == 'R' && trace.side == 'L') || (side == 'L' && trace.side == 'R');
  if (is_other) mirror(*ring);
  const std::vector<Polar> curves = curves_through(*ring);
  draw_ring(curves, trace, canvas);
  check_boxes(records, trace, curves, canvas);
  ignore_rest(records, trace, canvas);
}

}  // namespace
}  // namespace trace

void read_trace(const base::SourceFile& file, base::FileId id, Canvas& canvas) {
  FileFacts& facts = canvas.begin_file(id, "trace");
  facts.unit = "mm";
  facts.unit_from = "TRCFMT";
  const trace::Records records = trace::records_of(file, id);
  const trace::Trace* const trace = trace::chosen(records, canvas.reading().lens_side);
  if (trace == nullptr)
    return canvas.find(base::Severity::error, base::Code::trace_format, trace::line_of(1),
                       "there is no TRCFMT");
  facts.version = trace->format.substr(0, 20);
  if (canvas.wants(kLensLayer)) trace::draw(records, *trace, canvas);
}

}  // namespace kerf::drawing
