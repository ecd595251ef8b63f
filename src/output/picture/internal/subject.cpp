#include "output/picture/internal/subject.hpp"

#include "output/picture/drawing/palette.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kSmallestPart = 1e-4;  // mm; anything smaller is shown as a point
constexpr double kPointWindow = 10;     // mm
constexpr double kFlattest = 0.25;      // of a part's largest side, for one that is flat in X and Y

void widen(Box3& box, std::size_t side, double size) {
  const double missing = size - box.size()[side];
  if (missing <= 0) return;
  Point3 low = box.low(), high = box.high();
  low[side] -= missing / 2;
  high[side] += missing / 2;
  box.add(low);
  box.add(high);
}

// The cuts, or everything when nothing is cut: rapids from far away do not make the part tiny. A
// single hole or point still gets some room around it.
Box3 box_to_show(const PathRecorder& recorded) {
  Box3 box = recorded.cut_extents().empty() ? recorded.all_extents() : recorded.cut_extents();
  const double span = box.largest_side() < kSmallestPart ? kPointWindow : box.largest_side();
  const std::size_t across = recorded.has_y() ? kY : kZ;
  if (std::max(box.size()[kX], box.size()[across]) < kFlattest * span) {
    widen(box, kX, kFlattest * span);
    widen(box, across, kFlattest * span);
  }
  return box;
}

}  // namespace

Subject::Subject(const PathRecorder& recorder, const CutRecorder* cuts)
    : recorded(recorder),
      path(recorder.store().path()),
      tolerance(recorder.store().tolerance()),
      box(box_to_show(recorder)) {
  for (const Tool& tool : recorded.tools()) {
    const Color own = kToolColors[cutters.size() % kToolColors.size()];
    tool_color.push_back(cuts ? kSoft : own);
    if (tool.cuts) cutters.push_back(tool_color.size() - 1);
  }
  if (!cuts) return;
  values = cuts->path();
  cut_scale = cuts->measure().scale();
  cut_caption = cuts->measure().caption();
  tolerance = std::max(tolerance, cuts->tolerance());
}

std::string Subject::tool_name(std::size_t tool) const {
  const auto& [number, thread, cuts, first_cut] = recorded.tools()[tool];
  const std::string name = number == 0 ? "no tool" : 'T' + std::to_string(number);
  return thread ? name + " thread" : name;
}

}  // namespace kerf::output::plot
