#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "output/part/internal/region_path.hpp"
#include "output/part/internal/sheet_parts.hpp"
#include "output/part/part_picture.hpp"
#include "output/picture/drawing/ruler.hpp"

namespace kerf::output {
namespace {

using namespace plot;
using geometry::Vec2;
using stock::sheet::Sheet;

constexpr Color kSheetColor{222, 215, 202}, kLooseColor{196, 214, 232}, kCutColor{58, 52, 48};
constexpr double kLowest = 360, kHighest = 760;
constexpr double kPixelsPerUnit = 1.5;

/// From little energy to the most, as glowing metal.
constexpr std::array<Color, 6> kHeat{
    {{92, 20, 84}, {150, 32, 92}, {205, 60, 66}, {240, 112, 36}, {252, 176, 46}, {252, 240, 150}}};

Color mixed(Color a, Color b, double share) {
  const auto part = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::nearbyint(from + share * (to - from)));
  };
  return {part(a.red, b.red), part(a.green, b.green), part(a.blue, b.blue)};
}

Color heat(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (kHeat.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), kHeat.size() - 2);
  return mixed(kHeat[first], kHeat[first + 1], at - static_cast<double>(first));
}

/// The cells of a sheet as a picture.
class BurnMap {
 public:
  explicit BurnMap(const Sheet& sheet) : sheet_(sheet), peak_(sheet.peak_j_mm2()) {}

  [[nodiscard]] bool has_energy() const { return peak_ > 0; }
  [[nodiscard]] double peak() const { return peak_; }

  [[nodiscard]] Image image(int width, int height) const {
    Image out;
    out.width = width;
    out.height = height;
    out.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Color color = pixel(x, y, width, height);
        for (const std::uint8_t part : {color.red, color.green, color.blue})
          out.rgb.push_back(static_cast<char>(part));
      }
    }
    return out;
  }

 private:
  struct Range {
    int first;
    int last;
  };
  static Range cells(int pixel, int pixels, int count) {
    const auto cell = [&](int p) {
      return static_cast<int>(static_cast<std::int64_t>(p) * count / pixels);
    };
    const int first = cell(pixel);
    return {first, std::max(first, cell(pixel + 1) - 1)};
  }

  /// The hottest of its cells, and as dark as the mean of what is cut of them.
  [[nodiscard]] Color pixel(int x, int y, int width, int height) const {
    const stock::sheet::Grid& grid = sheet_.grid();
    const Range i = cells(x, width, grid.nx);
    const Range j = cells(height - 1 - y, height, grid.ny);
    double covered = 0;
    double hottest = 0;
    for (int row = j.first; row <= j.last; ++row) {
      for (int column = i.first; column <= i.last; ++column) {
        const auto [coverage, energy] = cell(column, row);
        covered += coverage;
        hottest = std::max(hottest, energy);
      }
    }
    const double count = double(i.last - i.first + 1) * double(j.last - j.first + 1);
    if (hottest > 0) return heat(hottest / peak_);
    return mixed(kSheetColor, kCutColor, covered / count);
  }

  struct Cell {
    double coverage = 0;
    double energy = 0;
  };
  [[nodiscard]] Cell cell(int i, int j) const {
    using stock::sheet::kTileSide;
    const auto tile =
        static_cast<std::size_t>((j / kTileSide) * sheet_.grid().tiles_x() + i / kTileSide);
    const auto at = static_cast<std::size_t>((j % kTileSide) * kTileSide + i % kTileSide);
    Cell out;
    if (const auto* const coverage = sheet_.coverage(tile)) out.coverage = (*coverage)[at] / 255.0;
    if (const auto* const energy = sheet_.energy(tile)) out.energy = double{(*energy)[at]};
    return out;
  }

  const Sheet& sheet_;
  double peak_;
};

/// Outer loops that do not touch the border of the sheet, with what lies in them.
contour::Region loose_pieces(const contour::Region& pieces, const contour::Box& sheet) {
  constexpr double kBorder_mm = 1e-6;
  const auto parents = contour::parents(pieces);
  std::vector<bool> is_loose(pieces.loops.size());
  for (std::size_t i = 0; i < pieces.loops.size(); ++i) {
    const contour::Box box = contour::extents(pieces.loops[i]);
    const bool touches =
        box.low.u <= sheet.low.u + kBorder_mm || box.low.v <= sheet.low.v + kBorder_mm ||
        box.high.u >= sheet.high.u - kBorder_mm || box.high.v >= sheet.high.v - kBorder_mm;
    is_loose[i] = contour::is_counterclockwise(pieces.loops[i]) && !touches;
  }
  contour::Region loose;
  for (std::size_t i = 0; i < pieces.loops.size(); ++i) {
    const bool is_outer = contour::is_counterclockwise(pieces.loops[i]);
    if (is_outer ? is_loose[i] : parents[i] && is_loose[*parents[i]])
      loose.loops.push_back(pieces.loops[i]);
  }
  return loose;
}

void draw_rulers(DisplayList& sheet, const Rect& frame, const contour::Box& box, double scale) {
  Outline border, ticks;
  border.rectangle(frame);
  for (const Tick& tick : ruler(box.low.u, box.high.u, 56 / scale)) {
    const double x = frame.left + scale * (tick.value - box.low.u);
    ticks.segment({x, frame.bottom()}, {x, frame.bottom() + (tick.major ? 6 : 3)});
    if (tick.major)
      sheet.add(Text{{x, frame.bottom() + 20}, tick.label, kTickText, Anchor::middle, kSoft});
  }
  for (const Tick& tick : ruler(box.low.v, box.high.v, 34 / scale)) {
    const double y = frame.bottom() - scale * (tick.value - box.low.v);
    ticks.segment({frame.left, y}, {frame.left - (tick.major ? 6 : 3), y});
    if (tick.major)
      sheet.add(Text{{frame.left - 10, y + 4}, tick.label, kTickText, Anchor::end, kSoft});
  }
  sheet.add(std::move(ticks), {kFrame, 1, false, {}});
  sheet.add(std::move(border), {Color{120, 112, 100}, 1, false, {}});
}

void draw_words(DisplayList& sheet, Point at, const std::string& text) {
  sheet.add(Text{at, text, 12.5, Anchor::start, kDark});
}

void draw_swatch(DisplayList& sheet, Point row, Color color, const std::string& text) {
  Outline box;
  box.rectangle({row.x, row.y - 10.5, 20, 13});
  sheet.add(std::move(box), {Color{90, 96, 104}, 0.8, false, color});
  draw_words(sheet, {row.x + 28, row.y}, text);
}

void draw_legend(DisplayList& sheet, double top, const PartScene& scene, const BurnMap& map) {
  const StockFacts::Sheet& facts = *scene.facts->sheet;
  const Point corner{kSheetMargin, top + 14};
  sheet.add(Text{corner, "Sheet", 12.5, Anchor::start, kDark, true});
  const auto row = [&](double x, int i) { return Point{x, corner.y + 21 * (i + 1)}; };
  draw_swatch(sheet, row(corner.x, 0), kSheetColor, "held by its border");
  draw_swatch(sheet, row(corner.x, 1), kLooseColor, "falls out");
  if (!map.has_energy()) draw_swatch(sheet, row(corner.x, 2), kCutColor, "cut");
  if (map.has_energy()) {
    const double x = corner.x + 230;
    sheet.add(Text{{x, corner.y}, "Energy, J/mm\u00b2", 12.5, Anchor::start, kDark, true});
    constexpr int kSteps = 60;
    constexpr double kStep = 5;
    for (int i = 0; i < kSteps; ++i) {
      Outline box;
      box.rectangle({x + kStep * i, corner.y + 12, kStep * (kSteps - i), 14});
      sheet.add(std::move(box), {{}, 1, false, heat((i + 0.5) / kSteps)});
    }
    for (const Tick& tick : ruler(0, map.peak(), 60 * map.peak() / (kStep * kSteps))) {
      if (!tick.major) continue;
      sheet.add(Text{{x + kStep * kSteps * tick.value / map.peak(), corner.y + 42},
                     tick.label,
                     kTickText,
                     Anchor::middle,
                     kSoft});
    }
  }
  const double x = corner.x + 610;
  sheet.add(Text{{x, corner.y}, "Cut", 12.5, Anchor::start, kDark, true});
  draw_words(sheet, row(x, 0),
             fmt::format("{} mm with a kerf of {} mm, {} mm\u00b2", short_number(facts.cut_mm, 2),
                         short_number(facts.kerf_mm, 4), short_number(facts.cut_mm2, 3)));
  std::uint64_t loose = 0;
  for (const StockFacts::Sheet::Piece& piece : facts.pieces) loose += piece.is_held ? 0 : 1;
  draw_words(sheet, row(x, 1),
             fmt::format("{} pieces, {} of them fall out", facts.piece_count, loose));
  if (facts.energy_j > 0)
    draw_words(sheet, row(x, 2),
               fmt::format("{} J in all, {} J/mm\u00b2 at most", short_number(facts.energy_j, 2),
                           short_number(facts.peak_j_mm2, 3)));
  for (std::size_t i = 0; i < std::min<std::size_t>(2, scene.facts->findings.size()); ++i) {
    const StockFacts::Told& told = scene.facts->findings[i];
    sheet.add(Text{
        row(x, 3 + static_cast<int>(i)),
        told.diagnostic.number +
            (told.finding.block.line > 0 ? fmt::format(", line {}", told.finding.block.line) : ""),
        12.5, Anchor::start, mark_color(told)});
  }
  sheet.height = std::ceil(corner.y + 21 * 6 + 12);
}

}  // namespace

DisplayList draw_burnt(const PartScene& scene) {
  DisplayList sheet;
  sheet.width = kSheetWidth;
  draw_head(sheet, scene,
            "The sheet seen from above \u00b7 where the beam was, and what falls out");
  const contour::Box& box = scene.sheet->grid().box;
  const double wide = box.high.u - box.low.u;
  const double high = box.high.v - box.low.v;
  const double scale =
      std::min((kSheetInner - kRulerLeft) / wide,
               std::clamp((kSheetInner - kRulerLeft) * high / wide, kLowest, kHighest) / high);
  const double left = kSheetMargin + kRulerLeft + (kSheetInner - kRulerLeft - scale * wide) / 2;
  const Rect frame{left, kPictureTop, scale * wide, scale * high};
  const BurnMap map(*scene.sheet);
  const auto pixels = [](double units) {
    return std::max(1, static_cast<int>(std::round(kPixelsPerUnit * units)));
  };
  Image image = map.image(pixels(frame.width), pixels(frame.height));
  image.at = frame;
  sheet.add(std::move(image));
  const ToSheet to_sheet = [&](Vec2 p) {
    return Point{frame.left + scale * (p.u - box.low.u),
                 frame.bottom() - scale * (p.v - box.low.v)};
  };
  if (scene.pieces) {
    sheet.add(path_of(loose_pieces(*scene.pieces, box), to_sheet), {{}, 1, false, kLooseColor});
  }
  draw_rulers(sheet, frame, box, scale);
  draw_legend(sheet, frame.bottom() + kRulerBelow, scene, map);
  return sheet;
}

}  // namespace kerf::output
