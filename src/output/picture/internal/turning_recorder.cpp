#include "output/picture/internal/turning_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "motion/surface_path.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kStep_deg = 3;  // of the rotary axis, between places of a line

std::unique_ptr<const motion::AxisSetup> part_space() {
  auto space = std::make_unique<motion::AxisSetup>();
  for (const char letter : {'X', 'Y', 'Z'}) {
    motion::AxisConfig axis;
    axis.letter = letter;
    space->axes.push_back(axis);
  }
  return space;
}

std::optional<base::Axis> first_rotary(const motion::AxisSetup& axes) {
  for (std::size_t i = 0; i < axes.count(); ++i) {
    if (axes.axes[i].rotary) return base::Axis{static_cast<std::uint8_t>(i)};
  }
  return std::nullopt;
}

bool is_deeper(const ThreadCut& cut, const ThreadCut& other) {
  return std::abs(cut.from[kX]) < std::abs(other.from[kX]);
}

}  // namespace

TurningRecorder::TurningRecorder(const motion::AxisSetup& axes, const ToolTable& table)
    : axes_(axes),
      table_(table),
      x_(axes.find('X')),
      z_(axes.find('Z')),
      rotary_(first_rotary(axes)),
      tip_(axes.start),
      space_(part_space()),
      face_(*space_) {}

const TurningTool& TurningRecorder::tool(std::uint32_t number) const {
  static const TurningTool kNone{};
  const auto found = std::ranges::find(tools_, number, &TurningTool::number);
  return found == tools_.end() ? kNone : *found;
}

TurningTool& TurningRecorder::at_work(std::uint32_t number) {
  auto found = std::ranges::find(tools_, number, &TurningTool::number);
  if (found == tools_.end()) {
    if (tools_.size() == PathRecorder::kMaxTools) return tools_.back();
    found = tools_.insert(found, {number, {}, table_.radius(number), false});
  }
  return *found;
}

void TurningRecorder::take(const motion::Motion& motion, const PathRecorder& recorded,
                           const Point3& from) {
  if (std::holds_alternative<motion::ToolChange>(motion.action)) early_.clear();
  const base::TipPoint* const to = motion::target_of(motion);
  if (to == nullptr) return;
  TurningTool& tool = at_work(recorded.tool().number);
  if (motion::is_cut(motion)) tool.nose = table_.nose(tool.number, motion.length.offset);
  const auto* const cut = std::get_if<motion::Thread>(&motion.action);
  if (cut != nullptr) thread(*cut, from, recorded.position());
  threading_ = cut != nullptr;
  if (rotary_) keep(motion, tool);
  tip_ = *to;
}

// Where the axis of the spindle moves, the tool was driven before, too.
void TurningRecorder::keep(const motion::Motion& motion, TurningTool& tool) {
  constexpr std::size_t kMostEarly = 100;
  const base::TipPoint& to = *motion::target_of(motion);
  tool.driven = tool.driven || to[*rotary_] != tip_[*rotary_];
  if (!tool.driven) {
    if (early_.size() < kMostEarly) early_.push_back({motion, tip_});
    return;
  }
  for (const Early& move : early_) on_part(move.motion, move.from, tool);
  early_.clear();
  on_part(motion, tip_, tool);
}

// Of the passes along the same way the deepest; what follows a thread at once is its run-out.
void TurningRecorder::thread(const motion::Thread& thread, const Point3& from, const Point3& to) {
  const ThreadCut cut{from, to, thread.lead};
  const double way = std::abs(to[kZ] - from[kZ]);
  if (threading_ || way < std::abs(to[kX] - from[kX]) / 2) return;
  const auto same = std::ranges::find_if(threads_, [&](const ThreadCut& other) {
    return other.lead == cut.lead && std::abs(other.to[kZ] - cut.to[kZ]) < 2 * cut.lead &&
           std::abs(other.from[kX] - cut.from[kX]) < cut.lead;
  });
  if (same == threads_.end()) {
    if (threads_.size() < kMostThreads) threads_.push_back(cut);
  } else if (is_deeper(cut, *same)) {
    *same = cut;
  }
}

base::TipPoint TurningRecorder::place(const base::TipPoint& tip) const {
  const auto [sine, cosine] = geometry::sine_cosine_deg(rotary_ ? tip[*rotary_] : 0);
  const double x = x_ ? tip[*x_] : 0;
  return {{x * cosine, x * sine, z_ ? tip[*z_] : 0}};
}

void TurningRecorder::go(const base::TipPoint& to, bool cuts) {
  motion::Motion step;
  if (cuts) {
    step.action = motion::Line{place(to), {}};
  } else {
    step.action = motion::Rapid{place(to)};
  }
  face_.take(step);
}

// A move of C at one radius goes round the part.
void TurningRecorder::way(const base::TipPoint& from, const base::TipPoint& to, bool cuts) {
  constexpr double kMost = 400;
  const double turned = rotary_ ? std::abs(to[*rotary_] - from[*rotary_]) : 0;
  const double count = std::clamp(std::ceil(turned / kStep_deg), 1.0, kMost);
  for (double n = 1; n <= count; ++n) {
    base::TipPoint at = to;
    for (std::size_t i = 0; n < count && i < axes_.count(); ++i)
      at.values[i] = from.values[i] + (to.values[i] - from.values[i]) * n / count;
    go(at, cuts);
  }
}

void TurningRecorder::on_part(const motion::Motion& motion, const base::TipPoint& from,
                              const TurningTool& tool) {
  constexpr double kChords = 8;
  if (face_.tool().number != tool.number) {
    motion::Motion change;
    change.action = motion::ToolChange{tool.number};
    face_.take(change);
  }
  const auto* const surface = std::get_if<motion::SurfaceMove>(&motion.action);
  if (surface == nullptr) return way(from, *motion::target_of(motion), motion::is_cut(motion));
  const motion::SurfacePath path(axes_, from, *surface, [&](const motion::Curve& curve) {
    for (double n = 1; n <= kChords; ++n) go(curve.at(curve.length() * n / kChords), true);
  });
}

}  // namespace kerf::output::plot
