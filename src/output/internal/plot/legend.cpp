#include "output/internal/plot/legend.hpp"

#include <algorithm>
#include <cmath>

#include "output/internal/plot/palette.hpp"
#include "output/internal/plot/path_painter.hpp"
#include "output/internal/plot/plan_view.hpp"
#include "output/internal/plot/text.hpp"

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

// Columns of five; the last place says how many there is no room for.
void draw_tools(DisplayList& sheet, Point corner, const Subject& subject) {
  constexpr std::size_t kRows = 5, kColumns = 5;
  constexpr double kColumn = 118;
  draw_heading(sheet, corner, "Tools");
  const std::size_t count = subject.cutters.size();
  const std::size_t shown = count <= kRows * kColumns ? count : kRows * kColumns - 1;
  const auto place = [&](std::size_t i) {
    const double x = corner.x + kColumn * static_cast<double>(i / kRows);
    return row_at({x, corner.y}, i % kRows);
  };
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t tool = subject.cutters[i];
    draw_sample(sheet, place(i), {subject.tool_color[tool], 4, false, {}});
    draw_words(sheet, place(i), subject.tool_name(tool));
  }
  if (shown < count) draw_words(sheet, place(shown), "+ " + grouped(count - shown) + " more");
  if (count == 0) draw_words(sheet, place(0), "nothing is cut");
}

std::string hole_count(const HoleFinder& finder) {
  const std::size_t count = finder.holes().size();
  const std::string more = finder.overflowed() ? "more than " : "";
  return more + grouped(count) + (count == 1 ? " hole" : " holes");
}

void draw_signs(DisplayList& sheet, Point corner, const Subject& subject) {
  draw_heading(sheet, corner, "Signs");
  const auto middle = [&](std::size_t row) {
    const Point at = row_at(corner, row);
    return Point{at.x + kSwatch / 2, at.y};
  };
  draw_sample(sheet, row_at(corner, 0), {kTravel, 1, true, {}});
  draw_words(sheet, row_at(corner, 0), "rapid, not cutting");
  draw_sample(sheet, row_at(corner, 1), {kDark, 1.6, false, {}});
  draw_words(sheet, row_at(corner, 1), "cut, in the tool's colour");
  draw_start_mark(sheet, middle(2));
  draw_words(sheet, row_at(corner, 2), subject.has_cuts() ? "first cut" : "start");
  draw_end_mark(sheet, middle(3));
  draw_words(sheet, row_at(corner, 3), subject.has_cuts() ? "end of the last cut" : "end");
  if (subject.recorded.hole_finder().holes().empty()) return;
  draw_hole_mark(sheet, middle(4));
  draw_words(sheet, row_at(corner, 4), hole_count(subject.recorded.hole_finder()));
}

// Enough decimals to tell the two ends of a small part.
int decimals_for(double size) { return size >= 1 || size == 0 ? 3 : 6; }

void draw_cell(DisplayList& sheet, Point right, const std::string& text, Color color) {
  sheet.add(Text{right, text, kTextSize, Anchor::end, color});
}

// From and to, and the size when asked for, right-aligned in columns that end at `right`.
void draw_range(DisplayList& sheet, Point row, std::span<const double> right, double low,
                double high) {
  const int decimals = decimals_for(high - low);
  const double y = row.y + 4.5;
  draw_cell(sheet, {right[0], y}, rounded(low, decimals), kDark);
  draw_cell(sheet, {right[1], y}, rounded(high, decimals), kDark);
  if (right.size() > 2) draw_cell(sheet, {right[2], y}, rounded(high - low, decimals), kDark);
}

// A row an axis: what the cuts span, and what all moves span with machine zero.
void draw_extents(DisplayList& sheet, Point corner, const Subject& subject) {
  const PathRecorder& recorded = subject.recorded;
  const std::array<double, 5> right{corner.x + 110, corner.x + 205, corner.x + 300, corner.x + 410,
                                    corner.x + 505};
  constexpr std::array<const char*, 5> kHeads{"cuts from", "to", "size", "all moves from", "to"};
  draw_heading(sheet, corner, "mm");
  for (std::size_t i = 0; i < right.size(); ++i) {
    draw_cell(sheet, {right[i], corner.y + 8}, kHeads[i], kSoft);
  }
  std::size_t row = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == kY && !recorded.has_y()) continue;
    const double factor = i == kX ? subject.x_factor() : 1;
    const Point at = row_at(corner, row++);
    const std::string name = std::string(1, "XYZ"[i]) + (factor == 1 ? "" : " \u2300");
    sheet.add(Text{{at.x, at.y + 4.5}, name, kTextSize, Anchor::start, kDark, true});
    const auto ends = [&](const Box3& box, std::span<const double> columns) {
      draw_range(sheet, at, columns, box.low()[i] * factor, box.high()[i] * factor);
    };
    if (subject.has_cuts()) ends(recorded.cut_extents(), std::span(right).first(3));
    ends(recorded.all_extents(), std::span(right).last(2));
  }
}

}  // namespace

void draw_legend(DisplayList& sheet, Point corner, double width, const Subject& subject) {
  draw_tools(sheet, corner, subject);
  draw_signs(sheet, {corner.x + width - 780, corner.y}, subject);
  draw_extents(sheet, {corner.x + width - 505, corner.y}, subject);
}

}  // namespace kerf::output::plot
