#include "output/picture/internal/legend.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "output/picture/drawing/palette.hpp"
#include "output/picture/drawing/ruler.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/internal/marks.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kRow = 22;
constexpr double kTextSize = 13;
constexpr double kSwatch = 30;

Point row_at(Point corner, std::size_t row) {
  return {corner.x, corner.y + 8 + kRow * static_cast<double>(row + 1)};
}

void draw_heading(DisplayList& sheet, Point at, const std::string& text) {
  sheet.add(Text{{at.x, at.y + 8}, text, kTextSize, Anchor::start, kDark, true});
}

void draw_words(DisplayList& sheet, Point row, const std::string& text) {
  sheet.add(Text{{row.x + kSwatch + 10, row.y + 4.5}, text, kTextSize, Anchor::start, kDark});
}

void draw_sample(DisplayList& sheet, Point row, const Ink& ink) {
  Outline sample;
  sample.segment(row, {row.x + kSwatch, row.y});
  sheet.add(std::move(sample), ink);
}

// Of a lathe tool also what its insert is taken for.
std::string words_of_tool(std::size_t tool, const Subject& subject, const Turning* turning) {
  const std::string name = subject.tool_name(tool);
  return turning == nullptr ? name : name + ": " + turning->inserts[tool].words();
}

// Columns of five, beginning at `corner`; the last place says how many there is no room for.
// Returns the width taken.
double draw_tools(DisplayList& sheet, Point corner, const Subject& subject,
                  const Turning* turning) {
  constexpr std::size_t kRows = 5;
  const std::size_t most_columns = turning == nullptr ? 5 : 2;
  const double column_width = turning == nullptr ? 114 : 275;
  draw_heading(sheet, corner, "Tools");
  const std::size_t count = subject.cutters.size();
  const std::size_t shown = count <= kRows * most_columns ? count : kRows * most_columns - 1;
  const auto place = [&](std::size_t i) {
    const double x = corner.x + column_width * static_cast<double>(i / kRows);
    return row_at({x, corner.y}, i % kRows);
  };
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t tool = subject.cutters[i];
    draw_sample(sheet, place(i), {subject.tool_color[tool], 4, false, {}});
    draw_words(sheet, place(i), words_of_tool(tool, subject, turning));
  }
  if (shown < count) draw_words(sheet, place(shown), "+ " + grouped(count - shown) + " more");
  if (count == 0) draw_words(sheet, place(0), "nothing is cut");
  const std::size_t columns = std::clamp<std::size_t>((count + kRows - 1) / kRows, 1, most_columns);
  return std::max(1.6, static_cast<double>(columns)) * column_width;
}

// The scale's colours, as boxes that overlap so that no gap shows between them.
void draw_ramp(DisplayList& sheet, const Rect& ramp, const CutScale& scale) {
  const double step = ramp.width / static_cast<double>(scale.shades());
  for (std::size_t place = 0; place < scale.shades(); ++place) {
    const double left = ramp.left + step * static_cast<double>(place);
    Outline box;
    box.rectangle({left, ramp.top, ramp.right() - left, ramp.height});
    sheet.add(std::move(box), {{}, 1, false, scale.color_from_below(place)});
  }
}

// `ramp` is that of the even steps.
void draw_scale_marks(DisplayList& sheet, const Rect& ramp, double top) {
  constexpr double kApart = 50;  // pixels between numbers
  Outline marks;
  for (const Tick& tick : ruler(0, top, kApart * top / ramp.width)) {
    const double x = ramp.left + ramp.width * tick.value / top;
    marks.segment({x, ramp.bottom()}, {x, ramp.bottom() + (tick.major ? 6 : 3)});
    if (!tick.major) continue;
    sheet.add(Text{{x, ramp.bottom() + 20}, tick.label, kTickText, Anchor::middle, kDark});
  }
  sheet.add(std::move(marks), {kFrame, 1, false, {}});
}

// Returns the width taken.
double draw_values(DisplayList& sheet, Point corner, const Subject& subject) {
  constexpr double kRampWidth = 380, kRampHeight = 16;
  const CutScale& scale = *subject.cut_scale;
  const bool speeds = scale.of() == CutScale::Of::speeds;
  draw_heading(sheet, corner,
               speeds ? "Speed of the cuts as reached, mm/min" : "Energy of the cuts, J/mm");
  if (!scale.is_empty()) {
    const Rect ramp{corner.x, corner.y + 22, kRampWidth, kRampHeight};
    draw_ramp(sheet, ramp, scale);
    const double steps = static_cast<double>(scale.steps()) / static_cast<double>(scale.shades());
    draw_scale_marks(sheet, {ramp.left, ramp.top, ramp.width * steps, ramp.height}, scale.top());
    const Point below{corner.x, ramp.bottom() + 46};
    sheet.add(Text{below, subject.cut_caption, kTextSize, Anchor::start, kDark});
  } else {
    sheet.add(Text{row_at(corner, 0), "nothing is cut", kTextSize, Anchor::start, kDark});
  }
  return kRampWidth + 60;
}

std::string hole_count(const HoleFinder& finder) {
  const std::size_t count = finder.holes().size();
  const std::string more = finder.overflowed() ? "more than " : "";
  return more + grouped(count) + (count == 1 ? " hole" : " holes");
}

std::string cut_words(const Subject& subject) {
  if (!subject.cut_scale) return "cut, in the tool's colour";
  const bool speeds = subject.cut_scale->of() == CutScale::Of::speeds;
  return speeds ? "cut, coloured by its speed" : "cut, coloured by its energy";
}

void draw_signs(DisplayList& sheet, Point corner, const Subject& subject, const Turning* turning) {
  draw_heading(sheet, corner, "Signs");
  const auto middle = [&](std::size_t row) {
    const Point at = row_at(corner, row);
    return Point{at.x + kSwatch / 2, at.y};
  };
  draw_sample(sheet, row_at(corner, 0), {kTravel, 1, true, {}});
  draw_words(sheet, row_at(corner, 0), "rapid, not cutting");
  draw_sample(sheet, row_at(corner, 1), {kDark, 1.6, false, {}});
  draw_words(sheet, row_at(corner, 1), cut_words(subject));
  draw_start_mark(sheet, middle(2));
  draw_words(sheet, row_at(corner, 2), subject.has_cuts() ? "first cut" : "start");
  draw_end_mark(sheet, middle(3));
  draw_words(sheet, row_at(corner, 3), subject.has_cuts() ? "end of the last cut" : "end");
  if (turning != nullptr) {
    const Point at = row_at(corner, 4);
    draw_section_sample(sheet, {at.x, at.y - 7, kSwatch, 14});
    draw_words(sheet, at, "part, as the cuts leave it");
  }
  if (subject.recorded.hole_finder().holes().empty()) return;
  draw_hole_mark(sheet, middle(4));
  draw_words(sheet, row_at(corner, 4), hole_count(subject.recorded.hole_finder()));
}

// Enough decimals to tell the two ends of a small part, and few enough for a column.
int decimals_for(double low, double high) {
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest >= 1e6) return 0;
  return high - low >= 1 || high == low ? 3 : 6;
}

void draw_cell(DisplayList& sheet, Point right, const std::string& text, Color color) {
  sheet.add(Text{right, text, kTextSize, Anchor::end, color});
}

// Right ends of the table's columns, from the right edge of the table.
constexpr std::array<double, 3> kCutColumns{-385, -300, -215};
constexpr std::array<double, 2> kMoveColumns{-85, 0};
constexpr double kTableWidth = 570;

void draw_heads(DisplayList& sheet, Point corner, double right, const Subject& subject) {
  const double y = corner.y + 8;
  draw_heading(sheet, corner, "Extents, mm");
  draw_cell(sheet, {right + kMoveColumns[0], y}, "all moves from", kSoft);
  draw_cell(sheet, {right + kMoveColumns[1], y}, "to", kSoft);
  if (!subject.has_cuts()) return;
  draw_cell(sheet, {right + kCutColumns[0], y}, "cuts from", kSoft);
  draw_cell(sheet, {right + kCutColumns[1], y}, "to", kSoft);
  draw_cell(sheet, {right + kCutColumns[2], y}, "size", kSoft);
}

void draw_cuts_range(DisplayList& sheet, Point row, double low, double high) {
  const int decimals = decimals_for(low, high);
  draw_cell(sheet, {row.x + kCutColumns[0], row.y}, base::rounded_text(low, decimals), kDark);
  draw_cell(sheet, {row.x + kCutColumns[1], row.y}, base::rounded_text(high, decimals), kDark);
  draw_cell(sheet, {row.x + kCutColumns[2], row.y}, base::rounded_text(high - low, decimals),
            kDark);
}

void draw_moves_range(DisplayList& sheet, Point row, double low, double high) {
  const int decimals = decimals_for(low, high);
  draw_cell(sheet, {row.x + kMoveColumns[0], row.y}, base::rounded_text(low, decimals), kDark);
  draw_cell(sheet, {row.x + kMoveColumns[1], row.y}, base::rounded_text(high, decimals), kDark);
}

// A row an axis: what the cuts span, and what all moves span with the start.
void draw_extents(DisplayList& sheet, Point corner, const Subject& subject) {
  const PathRecorder& recorded = subject.recorded;
  const double right = corner.x + kTableWidth;
  draw_heads(sheet, corner, right, subject);
  std::size_t row = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == kY && !recorded.has_y()) continue;
    const double factor = i == kX ? subject.x_factor() : 1;
    const Point at = row_at(corner, row++);
    const std::string name = std::string(1, "XYZ"[i]) + (factor == 1 ? "" : " \u2300");
    sheet.add(Text{{at.x, at.y + 4.5}, name, kTextSize, Anchor::start, kDark, true});
    const Point cells{right, at.y + 4.5};
    const Box3 &cuts = recorded.cut_extents(), all = recorded.all_extents();
    if (!cuts.empty()) {
      draw_cuts_range(sheet, cells, cuts.low()[i] * factor, cuts.high()[i] * factor);
    }
    draw_moves_range(sheet, cells, all.low()[i] * factor, all.high()[i] * factor);
  }
}

}  // namespace

void draw_legend(DisplayList& sheet, Point corner, double width, const Subject& subject,
                 const Turning* turning) {
  const double colors = subject.cut_scale ? draw_values(sheet, corner, subject)
                                          : draw_tools(sheet, corner, subject, turning);
  draw_signs(sheet, {corner.x + colors, corner.y}, subject, turning);
  draw_extents(sheet, {corner.x + width - kTableWidth, corner.y}, subject);
}

}  // namespace kerf::output::plot
