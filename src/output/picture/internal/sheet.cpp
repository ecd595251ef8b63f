#include "output/picture/internal/sheet.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "output/picture/drawing/palette.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/internal/half_section.hpp"
#include "output/picture/internal/iso_view.hpp"
#include "output/picture/internal/legend.hpp"
#include "output/picture/internal/plan_view.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kWidth = 1600;
constexpr double kMargin = 36;
constexpr double kInner = kWidth - 2 * kMargin;
constexpr double kViewsTop = 112;
constexpr double kLowest = 380, kHighest = 760;  // height of the views
constexpr double kIsoWidth = (kInner - kRulerLeft) / 2;

// Free space between a view's frame and the box in it.
struct Padding {
  double left, right, top, bottom;
};
constexpr Padding kPlanPadding{44, 44, 44, 44};
constexpr Padding kIsoPadding{92, 92, 40, 52};
constexpr Padding kLathePadding{60, 90, 84, 36};  // inserts stand behind and above their tip
constexpr double kFaceWidth = 480;

Rect inside(const Rect& frame, const Padding& padding) {
  return {frame.left + padding.left, frame.top + padding.top,
          frame.width - padding.left - padding.right, frame.height - padding.top - padding.bottom};
}

// How high a frame of this width must be for the box to fill the width.
double height_for(const Projection& projection, const Box3& box, double width,
                  const Padding& padding) {
  const Point size = seen_size(projection, box);
  if (size.x <= 0) return kHighest;
  return (width - padding.left - padding.right) * size.y / size.x + padding.top + padding.bottom;
}

std::string quantity(const CutScale& scale) {
  return scale.of() == CutScale::Of::speeds ? "speed reached" : "energy per millimetre";
}

std::string subtitle(const Subject& subject) {
  const std::uint64_t moves = subject.recorded.move_count();
  std::string text = "Tool path in machine coordinates \u00b7 " + grouped(moves) +
                     (moves == 1 ? " move" : " moves");
  if (subject.cut_scale) text += " \u00b7 coloured by the " + quantity(*subject.cut_scale);
  if (subject.tolerance > 0) {
    text += " \u00b7 simplified to about " + significant(subject.tolerance) + " mm";
  }
  return text;
}

void draw_head(DisplayList& sheet, const Subject& subject) {
  const std::string title = fitted(sheet.title, 24, Weight::bold, kInner);
  sheet.add(Text{{kMargin, 44}, title, 24, Anchor::start, kDark, true});
  sheet.add(Text{{kMargin, 68}, subtitle(subject), 13, Anchor::start, kSoft});
}

void draw_caption(DisplayList& sheet, const Rect& frame, std::string text, Look look) {
  if (look == Look::shaded) text += ", dense path shaded: higher is lighter";
  sheet.add(Text{{frame.left, frame.top - 10}, std::move(text), 14, Anchor::start, kSoft});
}

double draw_two_views(DisplayList& sheet, const Subject& subject) {
  const double plan_width = kInner - kIsoWidth - kRulerLeft;
  const double height =
      std::clamp(std::max(height_for(kIsometric, subject.box, kIsoWidth, kIsoPadding),
                          height_for(kFromAbove, subject.box, plan_width, kPlanPadding)),
                 kLowest, kHighest);
  const Rect iso{kMargin, kViewsTop, kIsoWidth, height};
  const Rect plan{iso.right() + kRulerLeft, kViewsTop, plan_width, height};
  const View from_front(kIsometric, subject.box, iso, inside(iso, kIsoPadding));
  draw_caption(sheet, iso, "Isometric", draw_iso(sheet, from_front, subject));
  const View from_above(kFromAbove, subject.box, plan, inside(plan, kPlanPadding));
  draw_caption(sheet, plan, "Top view", draw_plan(sheet, from_above, subject));
  return plan.bottom();
}

double draw_one_view(DisplayList& sheet, const Subject& subject) {
  const double width = kInner - kRulerLeft;
  const double height =
      std::clamp(height_for(kLathe, subject.box, width, kPlanPadding), kLowest, kHighest);
  const Rect frame{kMargin + kRulerLeft, kViewsTop, width, height};
  const View view(kLathe, subject.box, frame, inside(frame, kPlanPadding));
  draw_caption(sheet, frame, "ZX plane", draw_plan(sheet, view, subject));
  return frame.bottom();
}

// The face of the part as driven tools have cut it, in the colours of the other view.
void draw_face(DisplayList& sheet, const Rect& frame, const Subject& subject,
               const PathRecorder& recorded) {
  Subject face(recorded, nullptr);
  for (std::size_t i = 0; i < face.tool_color.size(); ++i) {
    const auto same = [&](const Tool& tool) {
      return tool.number == recorded.tools()[i].number && !tool.thread;
    };
    const auto found = std::ranges::find_if(subject.recorded.tools(), same);
    const auto pen = static_cast<std::size_t>(found - subject.recorded.tools().begin());
    if (pen < subject.tool_color.size()) face.tool_color[i] = subject.tool_color[pen];
  }
  const View along_z(kFromAbove, face.box, frame, inside(frame, kPlanPadding));
  draw_plan(sheet, along_z, face);
  draw_caption(sheet, frame, "Face, C at 0", Look::lines);
}

double draw_lathe_views(DisplayList& sheet, const Subject& subject, const Turning& turning) {
  const PathRecorder& face = turning.recorded.face();
  const bool has_face = !face.cut_extents().empty();
  const double face_width = has_face ? kFaceWidth : 0;
  const double width = kInner - kRulerLeft - (has_face ? face_width + kRulerLeft : 0);
  const Box3 box = half_section_box(subject);
  const double lowest = has_face ? face_width : kLowest;
  const double height = std::clamp(height_for(kLathe, box, width, kLathePadding), lowest, kHighest);
  const Rect frame{kMargin + kRulerLeft, kViewsTop, width, height};
  const View view(kLathe, box, frame, inside(frame, kLathePadding));
  draw_half_section(sheet, view, subject, turning);
  draw_caption(sheet, frame,
               "Half section: the path above the axis, what it leaves of the part below; shapes of "
               "inserts are "
               "assumed from how they move",
               Look::lines);
  if (has_face)
    draw_face(sheet, {frame.right() + kRulerLeft, kViewsTop, face_width, height}, subject, face);
  return frame.bottom();
}

}  // namespace

DisplayList draw_sheet(const PathRecorder& recorder, const TurningRecorder* turned,
                       const CutRecorder* cuts, const std::string& title) {
  const Subject subject(recorder, cuts);
  std::optional<Turning> turning;
  if (turned != nullptr) turning.emplace(subject, *turned);
  DisplayList sheet;
  sheet.width = kWidth;
  sheet.title = printable(title);
  draw_head(sheet, subject);
  const double bottom = turning            ? draw_lathe_views(sheet, subject, *turning)
                        : recorder.has_y() ? draw_two_views(sheet, subject)
                                           : draw_one_view(sheet, subject);
  const double legend_top = bottom + kRulerBelow + 24;
  draw_legend(sheet, {kMargin, legend_top}, kInner, subject, turning ? &*turning : nullptr);
  sheet.height = legend_top + kLegendHeight;
  return sheet;
}

}  // namespace kerf::output::plot
