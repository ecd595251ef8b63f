#include "engraver/pattern_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"
#include "math/math.hpp"
#include "output/picture/drawing/display_list.hpp"
#include "output/picture/drawing/palette.hpp"
#include "output/picture/drawing/png_writer.hpp"
#include "output/picture/drawing/ruler.hpp"
#include "output/picture/drawing/svg_writer.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/drawing/view.hpp"

namespace kerf::engraver {
namespace {

using output::plot::Anchor;
using output::plot::Box3;
using output::plot::Color;
using output::plot::DisplayList;
using output::plot::Ink;
using output::plot::Outline;
using output::plot::Point;
using output::plot::Rect;
using output::plot::Text;
using output::plot::View;

constexpr double kWidth = 1600;
constexpr double kHeight = 980;
constexpr Rect kPath{84, 112, 900, 800};
constexpr Rect kDetail{1064, 112, 500, 500};
constexpr double kPixelsPerUnit = 1.5;
constexpr double kShownOff = 0.03;  // of the path's extent: about what the worst place looks like
constexpr double kTick_px = 9;      // of a heading
constexpr double kTickApart_px = 26;
constexpr double kLeastDetail_mm = 0.05;
constexpr Color kTrue = output::plot::kTravel;
constexpr Color kWheel = output::plot::kToolColors[0];
constexpr Color kHeadingColor = output::plot::kToolColors[1];
constexpr Color kWorst = output::plot::kToolColors[6];

// A round number not above `value` > 0: 1, 2 or 5 times a power of ten.
double round_below(double value) {
  const double power = math::pow(10, std::floor(math::log10(value)));
  const double digits = value / power;
  return power * (digits >= 5 ? 5 : digits >= 2 ? 2 : 1);
}

/// One sheet; its parts share the knots.
class Sheet {
 public:
  Sheet(const std::vector<PatternPlot::Knot>& knots, const PatternPlot::Detail& detail,
        const PatternReport& report)
      : knots_(knots), detail_(detail), report_(report) {}

  DisplayList draw(const std::string& title);

 private:
  void head(const std::string& title);
  void frame(const Rect& rect, const View& view, const std::string& caption);
  void whole_path();
  void paths(const View& view, double factor);
  void headings(const View& view);
  void worst_mark(const View& view);
  void worst_place();
  void legend(double factor);
  [[nodiscard]] double magnification() const;
  [[nodiscard]] Box3 extents() const;
  static Point map(const View& view, double x, double y) { return view.map({x, y, 0}); }

  const std::vector<PatternPlot::Knot>& knots_;
  const PatternPlot::Detail& detail_;
  const PatternReport& report_;
  DisplayList sheet_;
};

Box3 Sheet::extents() const {
  Box3 box;
  for (const PatternPlot::Knot& knot : knots_) box.add({knot.x, knot.y, 0});
  if (box.empty()) box.add({0, 0, 0});
  if (box.largest_side() > 0) return box;
  box.add({box.low()[0] + 1, box.low()[1] + 1, 0});
  return box;
}

double Sheet::magnification() const {
  if (!(report_.measured.mm > 0)) return 1;
  return std::max(1.0, round_below(kShownOff * extents().largest_side() / report_.measured.mm));
}

void Sheet::head(const std::string& title) {
  sheet_.title = output::plot::printable(title);
  sheet_.add(Text{{36, 44},
                  output::plot::fitted(sheet_.title, 24, output::plot::Weight::bold, kWidth - 72),
                  24,
                  Anchor::start,
                  output::plot::kDark,
                  true});
  std::string text = output::plot::grouped(report_.triplets) + " triplets, " +
                     output::plot::grouped(report_.fast) + " fast records";
  if (report_.bound.line > 0) {
    text +=
        fmt::format(" \u00b7 the wheel leaves the path by at most {:.4f} mm, measured {:.4f} mm",
                    report_.bound.mm, report_.measured.mm);
  }
  sheet_.add(Text{{36, 68}, text, 13, Anchor::start, output::plot::kSoft});
}

void Sheet::frame(const Rect& rect, const View& view, const std::string& caption) {
  Outline grid;
  const double apart_mm = 70 / view.scale();
  const auto label = [&](Point at, const std::string& text, Anchor anchor) {
    sheet_.add(Text{at, text, 11, anchor, output::plot::kSoft});
  };
  for (const output::plot::Tick& tick :
       output::plot::ruler(view.left_mm(), view.right_mm(), apart_mm)) {
    if (!tick.major) continue;
    const double x = view.x_of(tick.value);
    grid.segment({x, rect.top}, {x, rect.bottom()});
    label({x, rect.bottom() + 16}, tick.label, Anchor::middle);
  }
  for (const output::plot::Tick& tick :
       output::plot::ruler(view.bottom_mm(), view.top_mm(), apart_mm)) {
    if (!tick.major) continue;
    const double y = view.y_of(tick.value);
    grid.segment({rect.left, y}, {rect.right(), y});
    label({rect.left - 6, y + 4}, tick.label, Anchor::end);
  }
  sheet_.add(std::move(grid), {output::plot::kGrid, 1, false, {}});
  Outline border;
  border.rectangle(rect);
  sheet_.add(std::move(border), {output::plot::kFrame, 1, false, {}});
  sheet_.add(Text{{rect.left, rect.top - 10}, caption, 14, Anchor::start, output::plot::kSoft});
}

void Sheet::paths(const View& view, double factor) {
  Outline travel;
  Outline path;
  Outline wheel;
  Point last{};
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const PatternPlot::Knot& knot = knots_[i];
    const Point on_path = map(view, knot.x, knot.y);
    const Point off = map(view, knot.x + factor * knot.off_x, knot.y + factor * knot.off_y);
    const bool jump = math::hypot(on_path.x - last.x, on_path.y - last.y) > 0.5;
    if (knot.down && i > 0 && jump) travel.segment(last, on_path);
    knot.down ? path.move_to(on_path) : path.line_to(on_path);
    knot.down ? wheel.move_to(off) : wheel.line_to(off);
    last = on_path;
  }
  sheet_.add(std::move(travel), {output::plot::kFaintTravel, 1, true, {}});
  sheet_.add(std::move(path), {kTrue, 2.5, false, {}});
  sheet_.add(std::move(wheel), {kWheel, 0.8, false, {}});
}

void Sheet::headings(const View& view) {
  Outline ticks;
  double way = 0;
  Point last{};
  for (const PatternPlot::Knot& knot : knots_) {
    const Point at = map(view, knot.x, knot.y);
    way += math::hypot(at.x - last.x, at.y - last.y);
    last = at;
    if (!knot.down && way < kTickApart_px) continue;
    way = 0;
    const auto [sine, cosine] = geometry::sine_cosine_deg(knot.heading_deg);
    ticks.segment({at.x - kTick_px * cosine, at.y + kTick_px * sine},
                  {at.x + kTick_px * cosine, at.y - kTick_px * sine});
  }
  sheet_.add(std::move(ticks), {kHeadingColor, 1.2, false, {}});
}

void Sheet::worst_mark(const View& view) {
  if (!(report_.measured.mm > 0)) return;
  Outline mark;
  mark.circle(map(view, report_.measured.x, report_.measured.y), 12);
  sheet_.add(std::move(mark), {kWorst, 1.5, false, {}});
}

void Sheet::whole_path() {
  const double factor = magnification();
  const View view(output::plot::kFromAbove, extents(), kPath, kPath.shrunk(48));
  frame(
      kPath, view,
      fmt::format("From above; deviations of the wheel \u00d7 {}", base::rounded_text(factor, 0)));
  paths(view, factor);
  headings(view);
  worst_mark(view);
  legend(factor);
}

void Sheet::worst_place() {
  if (detail_.wheel.empty()) return;
  Box3 box;
  for (const PathGauge::Place& place : detail_.wheel) box.add({place.x, place.y, 0});
  for (const PathGauge::Place& place : detail_.path) box.add({place.x, place.y, 0});
  if (box.largest_side() < kLeastDetail_mm)
    box.add({box.low()[0] + kLeastDetail_mm, box.low()[1] + kLeastDetail_mm, 0});
  const View view(output::plot::kFromAbove, box, kDetail, kDetail.shrunk(40));
  frame(kDetail, view,
        fmt::format("Circled place, true to scale: {:.4f} mm off, line {}", report_.measured.mm,
                    report_.measured.line));
  const auto draw = [&](const std::vector<PathGauge::Place>& places, const Ink& ink) {
    Outline line;
    for (const PathGauge::Place& place : places) {
      const Point at = map(view, place.x, place.y);
      line.empty() ? line.move_to(at) : line.line_to(at);
    }
    sheet_.add(std::move(line), ink);
  };
  draw(detail_.path, {kTrue, 2.5, false, {}});
  draw(detail_.wheel, {kWheel, 1, false, {}});
  Outline dots;
  for (const PathGauge::Place& place : detail_.wheel) dots.circle(map(view, place.x, place.y), 2);
  sheet_.add(std::move(dots), {{}, 1, false, kWheel});
}

void Sheet::legend(double factor) {
  double y = kDetail.bottom() + 60;
  const auto entry = [&](const Ink& ink, const std::string& text) {
    Outline line;
    line.segment({kDetail.left, y - 4}, {kDetail.left + 44, y - 4});
    sheet_.add(std::move(line), ink);
    sheet_.add(Text{{kDetail.left + 56, y}, text, 13, Anchor::start, output::plot::kDark});
    y += 26;
  };
  entry({kTrue, 2.5, false, {}}, "programmed path");
  entry({kWheel, 1, false, {}},
        fmt::format("wheel after every pulse; left: worst of a step \u00d7 {}",
                    base::rounded_text(factor, 0)));
  entry({kHeadingColor, 1.2, false, {}}, "heading of the wheel");
  entry({output::plot::kFaintTravel, 1, true, {}}, "from cut to cut");
}

DisplayList Sheet::draw(const std::string& title) {
  sheet_.width = kWidth;
  sheet_.height = kHeight;
  head(title);
  whole_path();
  worst_place();
  return std::move(sheet_);
}

}  // namespace

void PatternPlot::set_down(double x, double y, double heading_deg) {
  knots_.push_back({x, y, 0, 0, 0, heading_deg, true});
  last_ = {{{x, y}}, {}};
  detail_open_ = false;
  if (knots_.size() > kMostKnots) thin();
}

void PatternPlot::step(const PatternStep& step) {
  knots_.push_back({step.x, step.y, step.off_x, step.off_y, step.off_mm, step.heading_deg, false});
  add_detail(step);
  if (knots_.size() > kMostKnots) thin();
}

// The worst step, the one before and the one behind.
void PatternPlot::add_detail(const PatternStep& step) {
  const auto append = [&](Detail& to) {
    to.path.push_back({step.x, step.y});
    to.wheel.insert(to.wheel.end(), step.wheel.begin(), step.wheel.end());
  };
  if (detail_open_) append(detail_);
  detail_open_ = false;
  if (step.off_mm > worst_mm_) {
    worst_mm_ = step.off_mm;
    detail_ = last_;
    append(detail_);
    detail_open_ = true;
  }
  if (!last_.path.empty()) last_.path.erase(last_.path.begin(), last_.path.end() - 1);
  last_.wheel.clear();
  append(last_);
}

// Of each two neighbours within a cut the one farther off stays, and every place where a cut
// begins. Where nearly all are such places, the later half goes.
void PatternPlot::thin() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const bool pair = i + 1 < knots_.size() && !knots_[i].down && !knots_[i + 1].down;
    const bool next = pair && knots_[i + 1].off_mm > knots_[i].off_mm;
    knots_[kept++] = knots_[next ? i + 1 : i];
    if (pair) ++i;
  }
  knots_.resize(std::min(kept, kMostKnots / 4 * 3));
}

std::string PatternPlot::svg(const PatternReport& report) const {
  return output::plot::write_svg(Sheet(knots_, detail_, report).draw(title_));
}

std::string PatternPlot::png(const PatternReport& report) const {
  return output::plot::write_png(Sheet(knots_, detail_, report).draw(title_), kPixelsPerUnit);
}

}  // namespace kerf::engraver
