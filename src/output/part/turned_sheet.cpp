#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/part/internal/region_path.hpp"
#include "output/part/internal/sheet_parts.hpp"
#include "output/part/internal/solid_view.hpp"
#include "output/part/part_picture.hpp"
#include "output/picture/drawing/ruler.hpp"
#include "stock/surface/turned_surface.hpp"

namespace kerf::output {
namespace {

using namespace plot;
using contour::Region;
using geometry::Vec2;

constexpr Color kOutside{232, 236, 240}, kSection{240, 226, 200}, kHatchInk{176, 150, 104};
constexpr Color kClamp{186, 193, 202}, kClampInk{120, 128, 138};
constexpr double kSolidHeight = 330;
constexpr double kHalfLowest = 240, kHalfHighest = 460;
constexpr double kPadding = 40;

/// The half section of everything, on the sheet: above the axis from outside, below it cut.
class HalfSection {
 public:
  HalfSection(const PartScene& scene, const Paints& paints) : scene_(scene), paints_(paints) {
    take(scene.facts->stock_extents);
    box_.take(contour::extents(*scene.profile));
    for (const Region& fixture : scene.fixture_profiles) box_.take(contour::extents(fixture));
  }

  [[nodiscard]] double height_for(double width) const {
    const double scale = (width - 2 * kPadding) / std::max(1e-9, box_.high.u - box_.low.u);
    return 2 * box_.high.v * scale + 2 * kPadding;
  }

  void draw(DisplayList& sheet, const Rect& frame) {
    place(frame);
    draw_rulers(sheet, frame);
    draw_stock(sheet);
    for (const Region& fixture : scene_.fixture_profiles) draw_fixture(sheet, fixture);
    draw_outside(sheet);
    draw_section(sheet);
    draw_threads(sheet);
    draw_axis(sheet, frame);
    draw_findings(sheet, frame);
  }

 private:
  void take(const stock::Bounds& stock) {
    box_.take(Vec2{stock.low.z, 0});
    box_.take(Vec2{stock.high.z, stock.high.x});
  }

  void place(const Rect& frame) {
    const Rect inside = frame.shrunk(kPadding);
    scale_ = std::min(inside.width / std::max(1e-9, box_.high.u - box_.low.u),
                      inside.height / std::max(1e-9, 2 * box_.high.v));
    left_ = inside.center().x - scale_ * (box_.low.u + box_.high.u) / 2;
    axis_ = inside.center().y;
  }

  [[nodiscard]] Point above(Vec2 p) const { return {left_ + scale_ * p.u, axis_ - scale_ * p.v}; }
  [[nodiscard]] Point below(Vec2 p) const { return {left_ + scale_ * p.u, axis_ + scale_ * p.v}; }
  [[nodiscard]] ToSheet up() const {
    return [this](Vec2 p) { return above(p); };
  }
  [[nodiscard]] ToSheet down() const {
    return [this](Vec2 p) { return below(p); };
  }

  void draw_stock(DisplayList& sheet) const {
    const stock::Bounds& stock = scene_.facts->stock_extents;
    Outline box;
    const Point corner = above({stock.low.z, stock.high.x});
    const Point other = below({stock.high.z, stock.high.x});
    box.rectangle({corner.x, corner.y, other.x - corner.x, other.y - corner.y});
    sheet.add(std::move(box), {kAxis, 1.2, true, {}});
  }

  void draw_fixture(DisplayList& sheet, const Region& fixture) const {
    for (const ToSheet& side : {up(), down()}) {
      sheet.add(path_of(fixture, side), {kClampInk, 1, false, kClamp});
      sheet.add(hatch(fixture, side, 7), {kClampInk, 0.6, false, {}});
    }
  }

  /// What is seen from outside: everything between the axis and an edge, and the rings of corners.
  void draw_outside(DisplayList& sheet) const {
    Outline area;
    for (const contour::Contour& loop : scene_.profile->loops) {
      for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
        contour::Edge edge = contour::edge_of(loop, i);
        if (edge.from.u == edge.to.u) continue;
        if (edge.from.u > edge.to.u) edge = contour::reversed(edge);
        area.move_to(above({edge.from.u, 0}));
        area.line_to(above(edge.from));
        follow(area, edge, up());
        area.line_to(above({edge.to.u, 0}));
        area.close();
      }
    }
    sheet.add(std::move(area), {{}, 1, false, kOutside});
    Outline outline;
    for (const contour::Contour& loop : scene_.profile->loops) add_seen(loop, outline);
    sheet.add(std::move(outline), {Color{70, 78, 88}, 1.3, false, {}});
  }

  /// Edges that nothing hides, and a line to the axis at each corner that is seen, also where the
  /// wall that ends there is hidden, because it leans over.
  void add_seen(const contour::Contour& loop, Outline& outline) const {
    const std::size_t count = contour::edge_count(loop);
    for (std::size_t i = 0; i < count; ++i) {
      const contour::Edge edge = contour::edge_of(loop, i);
      if (!is_hidden(contour::point_at(edge, 0.5))) {
        outline.move_to(above(edge.from));
        follow(outline, edge, up());
      }
      const contour::Edge next = contour::edge_of(loop, (i + 1) % count);
      if (!is_hidden(edge.to) && is_corner(edge, next))
        outline.segment(above(edge.to), above({edge.to.u, 0}));
    }
  }

  [[nodiscard]] static bool is_corner(const contour::Edge& edge, const contour::Edge& next) {
    const Vec2 a = contour::tangent_at_end(edge);
    const Vec2 b = contour::tangent_at_start(next);
    const double size = length(a) * length(b);
    return std::fabs(cross(a, b)) > 0.02 * size;
  }

  /// Whether material stands between a point and who looks: farther out at the same Z.
  [[nodiscard]] bool is_hidden(Vec2 p) const {
    constexpr double kLittle = 1e-6;
    constexpr double kUpright = 1e-4;  // mm: an edge along X hides nothing
    if (p.v <= kLittle) return true;
    for (const contour::Contour& loop : scene_.profile->loops) {
      for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
        const contour::Edge edge = contour::edge_of(loop, i);
        const auto [low, high] = std::minmax(edge.from.u, edge.to.u);
        if (high - low < kUpright || p.u <= low + kLittle || p.u >= high - kLittle) continue;
        if (contour::point_at(edge, contour::nearest_share(edge, {p.u, 1e6})).v <= p.v) continue;
        if (height_at(edge, p.u) > p.v + kLittle) return true;
      }
    }
    return false;
  }
  /// Where an edge is over a Z between its ends.
  [[nodiscard]] static double height_at(const contour::Edge& edge, double u) {
    double low = 0, high = 1;
    const bool rises = edge.to.u > edge.from.u;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      ((contour::point_at(edge, middle).u < u) == rises ? low : high) = middle;
    }
    return contour::point_at(edge, low).v;
  }

  void draw_section(DisplayList& sheet) const {
    sheet.add(path_of(*scene_.profile, down()), {{}, 1, false, kSection});
    sheet.add(hatch(*scene_.profile, down(), 9), {kHatchInk, 0.8, false, {}});
    std::vector<Outline> by_paint(paints_.colors().size());
    for (const contour::Contour& loop : scene_.profile->loops) {
      for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
        const contour::Edge edge = contour::edge_of(loop, i);
        if (edge.from.v <= 0 && edge.to.v <= 0) continue;
        Outline& outline = by_paint[paints_.of_motion(edge.owner)];
        outline.move_to(below(edge.from));
        follow(outline, edge, down());
      }
    }
    for (std::size_t i = 0; i < by_paint.size(); ++i) {
      const Color color = i == Paints::kStock ? Color{110, 118, 128} : paints_.colors()[i];
      sheet.add(std::move(by_paint[i]), {color, i == Paints::kStock ? 1.3 : 2.6, false, {}});
    }
  }

  /// A thin line at the bottom of the groove, and where the thread ends a line across it.
  void draw_threads(DisplayList& sheet) const {
    Outline lines;
    for (const StockFacts::Thread& thread : scene_.facts->threads) {
      if (thread.axis != 'Z') continue;
      for (const bool is_above : {true, false}) {
        const auto at = [&](double z, double d) {
          return is_above ? above({z, d / 2}) : below({z, d / 2});
        };
        const double bottom = thread.is_inside ? thread.major : thread.minor;
        lines.segment(at(thread.from, bottom), at(thread.to, bottom));
        lines.segment(at(thread.to, thread.minor), at(thread.to, thread.major));
      }
    }
    sheet.add(std::move(lines), {Color{70, 78, 88}, 0.9, false, {}});
  }

  void draw_axis(DisplayList& sheet, const Rect& frame) const {
    Outline line;
    for (double x = frame.left + 8; x < frame.right() - 30; x += 26) {
      line.segment({x, axis_}, {std::min(x + 15, frame.right() - 8), axis_});
      line.segment({x + 20.2, axis_}, {x + 20.4, axis_});
    }
    sheet.add(std::move(line), {Color{150, 60, 60}, 1, false, {}});
  }

  void draw_rulers(DisplayList& sheet, const Rect& frame) const {
    Outline border, ticks, grid;
    border.rectangle(frame);
    for (const Tick& tick :
         ruler((frame.left - left_) / scale_, (frame.right() - left_) / scale_, 56 / scale_)) {
      const double x = left_ + scale_ * tick.value;
      ticks.segment({x, frame.bottom()}, {x, frame.bottom() + (tick.major ? 6 : 3)});
      if (!tick.major) continue;
      grid.segment({x, frame.top}, {x, frame.bottom()});
      sheet.add(Text{{x, frame.bottom() + 20}, tick.label, kTickText, Anchor::middle, kSoft});
    }
    for (const Tick& tick : ruler(0, (axis_ - frame.top) / scale_, 26 / scale_, 2)) {
      for (const double side : {-1.0, 1.0}) {
        const double y = axis_ + side * scale_ * tick.value;
        ticks.segment({frame.left, y}, {frame.left - (tick.major ? 6 : 3), y});
        if (!tick.major || (side > 0 && tick.value == 0)) continue;
        grid.segment({frame.left, y}, {frame.right(), y});
        sheet.add(Text{{frame.left - 10, y + 4}, tick.label, kTickText, Anchor::end, kSoft});
      }
    }
    sheet.add(
        Text{{frame.right() + 2, frame.bottom() + 34}, "Z, mm", kTickText, Anchor::end, kSoft});
    sheet.add(Text{{frame.left - 10, frame.top - 8}, "\u00d8 mm", kTickText, Anchor::end, kSoft});
    sheet.add(std::move(grid), {kGrid, 1, false, {}});
    sheet.add(std::move(ticks), {kFrame, 1, false, {}});
    sheet.add(std::move(border), {kFrame, 1, false, {}});
  }

  void draw_findings(DisplayList& sheet, const Rect& frame) const {
    std::vector<PlacedMark> marks;
    for (const Mark& mark : marks_of(scene_)) {
      const Vec3 at = mark.told->finding.at;
      marks.push_back({mark, above({at.z, std::fabs(at.x)}), false});
    }
    draw_marks(sheet, marks, frame);
  }

  const PartScene& scene_;
  const Paints& paints_;
  contour::Box box_;
  double scale_ = 1;
  double left_ = 0;
  double axis_ = 0;
};

/// The same things as solids with a quarter cut out.
PartScene opened(const PartScene& scene) {
  constexpr double kChord_mm = 0.01;
  constexpr double kQuarter = std::numbers::pi / 2;
  PartScene open;
  open.facts = scene.facts;
  open.tools = scene.tools;
  open.jobs = scene.jobs;
  open.is_opened = true;
  open.part = stock::surface::turned_open(*scene.profile, kChord_mm, kQuarter, 3 * kQuarter);
  for (const Region& fixture : scene.fixture_profiles) {
    open.fixtures.push_back(
        stock::surface::turned_open(fixture, kChord_mm, kQuarter, 3 * kQuarter));
  }
  return open;
}

}  // namespace

DisplayList draw_turned(const PartScene& scene) {
  const Paints paints(scene);
  DisplayList sheet;
  sheet.width = kSheetWidth;
  const bool ended = scene.facts->run.alarm.has_value();
  draw_head(
      sheet, scene,
      std::string(ended ? "The part when the alarm came" : "The part as it is left") +
          " \u00b7 with a quarter cut out, and its half section: above the axis from outside");
  const PartScene open = opened(scene);
  const SolidView solid(open, paints, lathe_view().camera);
  const Rect above{kSheetMargin, kPictureTop, kSheetInner,
                   std::round(std::clamp(solid.height_for(kSheetInner), 240.0, kSolidHeight))};
  solid.draw(sheet, above);
  HalfSection half(scene, paints);
  const double width = kSheetInner - kRulerLeft;
  const Rect below{kSheetMargin + kRulerLeft, above.bottom() + 30, width,
                   std::round(std::clamp(half.height_for(width), kHalfLowest, kHalfHighest))};
  half.draw(sheet, below);
  draw_foot(sheet, below.bottom() + kRulerBelow + 14, scene, paints);
  return sheet;
}

}  // namespace kerf::output
