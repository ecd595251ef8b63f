#include "output/part/internal/sheet_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/picture/drawing/label_placer.hpp"
#include "output/picture/drawing/text.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kRow = 21;
constexpr double kTextSize = 12.5;
constexpr double kDisc = 10.5;
constexpr std::size_t kRows = 6;

void heading(DisplayList& sheet, Point at, const std::string& text) {
  sheet.add(Text{at, text, kTextSize, Anchor::start, kDark, true});
}

Point row_at(Point corner, std::size_t row) {
  return {corner.x, corner.y + kRow * static_cast<double>(row + 1)};
}

void swatch(DisplayList& sheet, Point row, Color color) {
  Outline box;
  box.rectangle({row.x, row.y - 10.5, 20, 13});
  sheet.add(std::move(box), {Color{90, 96, 104}, 0.8, false, color});
}

void words(DisplayList& sheet, Point at, const std::string& text, double width,
           Color color = kDark) {
  sheet.add(
      Text{at, fitted(text, kTextSize, Weight::regular, width), kTextSize, Anchor::start, color});
}

std::string tool_words(const StockFacts::Tool& tool) {
  std::string text = fmt::format("T{} {}", tool.did.tool, tool.type);
  if (tool.diameter > 0) text += " \u00d8" + short_number(tool.diameter);
  return text + "  " + volume_text(tool.did.removed_mm3);
}

/// Returns the width taken.
double draw_tools(DisplayList& sheet, Point corner, const PartScene& scene, const Paints& paints) {
  constexpr double kColumn = 250;
  heading(sheet, corner, "Faces by tool");
  struct Row {
    Color color;
    std::string text;
  };
  std::vector<Row> rows{{kUncut, "uncut stock"}};
  if (!scene.fixtures.empty()) rows.push_back({kFixturePaint, "fixtures"});
  const auto& tools = scene.facts->tools;
  for (std::size_t i = 0; i < tools.size(); ++i)
    rows.push_back({paints.of_tool(i), tool_words(tools[i])});
  const std::size_t most = 2 * kRows;
  if (rows.size() > most) {
    const std::string more = fmt::format("and {} more tools", rows.size() - most + 1);
    rows.resize(most - 1);
    rows.push_back({kWhite, more});
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double x = corner.x + kColumn * static_cast<double>(i / kRows);
    const Point at = row_at({x, corner.y}, i % kRows);
    swatch(sheet, at, rows[i].color);
    words(sheet, {at.x + 28, at.y}, rows[i].text, kColumn - 40);
  }
  return kColumn * (rows.size() > kRows ? 2 : 1);
}

std::string extents_text(const stock::Bounds& box, bool turns) {
  if (box.low.x > box.high.x) return "nothing is left";
  const auto range = [](const char* axis, double low, double high) {
    return fmt::format("{} {} \u2026 {}", axis, short_number(low, 2), short_number(high, 2));
  };
  const std::string z = range("Z", box.low.z, box.high.z);
  if (turns) return "\u00d8" + short_number(2 * box.high.x, 2) + "   " + z;
  return range("X", box.low.x, box.high.x) + "   " + range("Y", box.low.y, box.high.y) + "   " + z;
}

double draw_part_facts(DisplayList& sheet, Point corner, const StockFacts& facts) {
  constexpr double kColumn = 330;
  heading(sheet, corner, "Part");
  std::vector<std::string> rows{
      "removed " + volume_text(facts.removed_mm3) + " of " + volume_text(facts.stock_mm3),
      "left " + volume_text(facts.left_mm3), extents_text(facts.extents, facts.turns)};
  if (!facts.model.cell_mm.empty()) {
    rows.push_back(fmt::format("{}, cells of {} mm", facts.model.kind,
                               short_number(facts.model.cell_mm.front(), 4)));
  } else {
    rows.push_back("exact lines and arcs");
  }
  if (facts.pieces.size() > 1) rows.push_back(fmt::format("{} pieces", facts.pieces.size()));
  rows.push_back(fmt::format("stock {} at {}", facts.shape, facts.zero));
  for (std::size_t i = 0; i < rows.size(); ++i)
    words(sheet, row_at(corner, i), rows[i], kColumn - 16);
  return kColumn;
}

std::string finding_words(const StockFacts::Told& told) {
  std::string text = told.diagnostic.number;
  if (told.finding.block.line > 0) text += fmt::format("  line {}", told.finding.block.line);
  if (told.finding.tool > 0) text += fmt::format("  T{}", told.finding.tool);
  if (told.finding.depth_mm > 0) text += "  " + short_number(told.finding.depth_mm) + " mm deep";
  return text;
}

void disc(DisplayList& sheet, Point center, double radius, Color color, std::size_t number) {
  Outline circle;
  circle.circle(center, radius);
  sheet.add(std::move(circle), {kWhite, 1.6, false, color});
  sheet.add(Text{{center.x, center.y + 0.36 * radius + 0.3},
                 std::to_string(number),
                 number < 10 ? 1.15 * radius : radius,
                 Anchor::middle,
                 kWhite,
                 true});
}

void draw_findings(DisplayList& sheet, Point corner, double width, const PartScene& scene) {
  const auto& told = scene.facts->findings;
  heading(sheet, corner, told.empty() ? "No finding" : fmt::format("Findings: {}", told.size()));
  std::vector<Mark> rows = marks_of(scene);
  for (const StockFacts::Told& each : told) {
    const bool is_marked =
        std::any_of(rows.begin(), rows.end(), [&](const Mark& mark) { return mark.told == &each; });
    if (!is_marked) rows.push_back({0, &each});
  }
  const std::size_t shown = rows.size() > kRows ? kRows - 1 : rows.size();
  for (std::size_t i = 0; i < shown; ++i) {
    const Point at = row_at(corner, i);
    const Color color = mark_color(*rows[i].told);
    if (rows[i].number > 0) disc(sheet, {at.x + 9, at.y - 4.5}, 8.5, color, rows[i].number);
    words(sheet, {at.x + 26, at.y}, finding_words(*rows[i].told), width - 26);
  }
  if (shown < rows.size())
    words(sheet, row_at({corner.x + 26, corner.y}, shown),
          fmt::format("and {} more", rows.size() - shown), width, kSoft);
}

}  // namespace

std::string short_number(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string volume_text(double mm3) {
  const double size = std::fabs(mm3);
  if (size < 100) return short_number(mm3, 2) + " mm\u00b3";
  std::string text = fmt::format("{:.0f}", mm3);
  for (std::ptrdiff_t at = std::ssize(text) - 3; at > (mm3 < 0 ? 1 : 0); at -= 3)
    text.insert(static_cast<std::size_t>(at), "\u2009");
  return text + " mm\u00b3";
}

void draw_head(DisplayList& sheet, const PartScene& scene, const std::string& about) {
  sheet.title = printable(scene.title);
  sheet.add(Text{{kSheetMargin, 40},
                 fitted(sheet.title, 24, Weight::bold, kSheetInner),
                 24,
                 Anchor::start,
                 kDark,
                 true});
  sheet.add(Text{{kSheetMargin, 63},
                 fitted(printable(about), 13, Weight::regular, kSheetInner),
                 13,
                 Anchor::start,
                 kSoft});
}

void draw_foot(DisplayList& sheet, double top, const PartScene& scene, const Paints& paints) {
  Point corner{kSheetMargin, top + 14};
  corner.x += draw_tools(sheet, corner, scene, paints) + 20;
  corner.x += draw_part_facts(sheet, corner, *scene.facts) + 16;
  draw_findings(sheet, corner, kSheetWidth - kSheetMargin - corner.x, scene);
  sheet.height = std::ceil(top + 14 + kRow * static_cast<double>(kRows) + 26);
}

Color mark_color(const StockFacts::Told& told) {
  return told.diagnostic.severity == base::Severity::error ? kErrorMark : kWarningMark;
}

std::vector<Mark> marks_of(const PartScene& scene) {
  std::vector<Mark> marks;
  for (const StockFacts::Told& told : scene.facts->findings) {
    if (told.finding.motion == 0 || marks.size() == kMostMarks) continue;
    marks.push_back({marks.size() + 1, &told});
  }
  return marks;
}

void draw_mark(DisplayList& sheet, const Mark& mark, Point place, Point center, bool is_hidden) {
  const Color color = mark_color(*mark.told);
  Outline under;
  under.segment(place, center);
  Outline leader = under;
  sheet.add(std::move(under), {kWhite, 3.6, false, {}});
  sheet.add(std::move(leader), {color, 1.6, is_hidden, {}});
  Outline dot;
  dot.circle(place, 4.2);
  sheet.add(std::move(dot),
            is_hidden ? Ink{color, 1.8, false, kWhite} : Ink{kWhite, 1.4, false, color});
  disc(sheet, center, kDisc, color, mark.number);
}

void draw_marks(DisplayList& sheet, const std::vector<PlacedMark>& marks, const Rect& area) {
  LabelPlacer placer(area.shrunk(4));
  for (const PlacedMark& each : marks) placer.reserve({each.place.x - 5, each.place.y - 5, 10, 10});
  for (const PlacedMark& each : marks) {
    constexpr double kSize = 2 * kDisc + 4;
    const auto found = placer.place(each.place, kSize, kSize, 20);
    const Point center = found ? found->center() : Point{each.place.x, each.place.y - 26};
    draw_mark(sheet, each.mark, each.place, center, each.is_hidden);
  }
}

void draw_scale_bar(DisplayList& sheet, Point right, double pixels_per_mm) {
  constexpr double kShortest = 70;
  double length = 1e-6;
  for (int step = 0; length * pixels_per_mm < kShortest && step < 60; ++step)
    length *= step % 3 == 1 ? 2.5 : 2;
  const double left = right.x - length * pixels_per_mm;
  Outline bar;
  bar.move_to({left, right.y - 5});
  bar.line_to({left, right.y});
  bar.line_to(right);
  bar.line_to({right.x, right.y - 5});
  sheet.add(std::move(bar), {kSoft, 1.4, false, {}});
  sheet.add(Text{{(left + right.x) / 2, right.y - 7},
                 short_number(length, 6) + " mm",
                 12,
                 Anchor::middle,
                 kSoft});
}

}  // namespace kerf::output::plot
