#include "face/server/hub/pulse_window.hpp"

#include <algorithm>
#include <array>

#include "drive/step_generator.hpp"

namespace kerf::server {
namespace {

constexpr double kNsPerSecond = 1e9;

class Edges : public drive::PulseSink {
 public:
  explicit Edges(const std::vector<machine::DrivenAxis>& joints) {
    for (const machine::DrivenAxis& joint : joints) json_[joint.name] = Json::array();
    for (const machine::DrivenAxis& joint : joints) lists_[count_++] = &json_[joint.name];
  }

  void take(const drive::Pulse& pulse) override {
    if (total_++ >= PulseWindow::kMostEdges) return;
    Json& list = *lists_[base::index(pulse.axis)];
    list.push_back(static_cast<double>(pulse.time_ns) / kNsPerSecond);
    list.push_back(drive::sign(pulse.direction));
  }

  [[nodiscard]] Json take_json() { return std::move(json_); }
  [[nodiscard]] bool full() const { return total_ >= PulseWindow::kMostEdges; }

 private:
  Json json_ = Json::object();
  std::array<Json*, base::kMaxAxes> lists_{};
  std::size_t count_ = 0;
  std::size_t total_ = 0;
};

}  // namespace

void PulseWindow::start(const motion::AxisPoint& at) {
  points_.clear();
  last_s_ = at.tip.time_s;
  if (last_s_ < awake_until_s_ - kAwake_s) awake_until_s_ = last_s_ + kAwake_s;  // a new run
  points_.push_back({at.tip.time_s, at.joints, at.tip.mark.block.line});
}

void PulseWindow::take(const motion::AxisPoint& point) {
  last_s_ = point.tip.time_s;
  if (last_s_ > awake_until_s_) {
    points_.clear();
    return;
  }
  points_.push_back({point.tip.time_s, point.joints, point.tip.mark.block.line});
  drop_before(last_s_ - kMost_s);
}

void PulseWindow::drop_before(double time_s) {
  while (points_.size() > 1 && points_[1].time_s <= time_s) points_.pop_front();
}

Json PulseWindow::edges(double seconds) {
  awake_until_s_ = last_s_ + kAwake_s;
  Edges edges(definition_.driven);
  drive::StepGenerator generator(definition_.step_axes(), definition_.drive.timing, edges);
  Json lines = Json::array();
  const double from_s = last_s_ - std::min(seconds, kMost_s);
  const auto later = [&](const Point& p) { return p.time_s >= from_s; };
  const auto first = std::find_if(points_.begin(), points_.end(), later);
  for (auto point = first; point != points_.end() && !edges.full(); ++point) {
    if (point == first) {
      generator.start({point->time_s, point->joints});
      continue;
    }
    // What the drive could not do is its alarm; here the step is only left out.
    if (!generator.move_to({point->time_s, point->joints}))
      generator.start({point->time_s, point->joints});
    if (lines.empty() || lines.back()[2] != point->line)
      lines.push_back({std::prev(point)->time_s, point->time_s, point->line});
    lines.back()[1] = point->time_s;
  }
  return {{"time_s", last_s_}, {"pulses", edges.take_json()}, {"lines", std::move(lines)}};
}

}  // namespace kerf::server
