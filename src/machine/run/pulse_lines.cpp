#include "machine/run/pulse_lines.hpp"

#include <algorithm>

namespace kerf::machine {

using drive::ArmAxis;

void PulseLines::begin(std::int64_t time_ns, const drive::ArmCounts& counts) {
  begin_ns_ = static_cast<double>(time_ns);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    Line& line = lines_[i];
    line.knots.clear();
    line.next = 0;
    line.count = counts.values[i];
    line.end_ns = begin_ns_;
    line.knots.push_back({begin_ns_, static_cast<double>(line.count)});
  }
}

void PulseLines::take(const drive::Pulse& pulse) {
  Line& line = lines_[index(pulse.axis)];
  const bool first = line.knots.size() == 1;
  // The arms of a triplet set out when the wheel has turned.
  const double wheel_ns = lines_[index(drive::axis_of(ArmAxis::theta3))].end_ns;
  if (first && wheel_ns > begin_ns_ && pulse.axis != drive::axis_of(ArmAxis::theta3))
    line.knots.push_back({wheel_ns, static_cast<double>(line.count)});
  const auto step = static_cast<double>(sign(pulse.direction));
  line.knots.push_back(
      {static_cast<double>(pulse.time_ns), static_cast<double>(line.count) + step / 2});
  line.count += sign(pulse.direction);
  line.end_ns = static_cast<double>(pulse.time_ns) + pulse.width_ns;
}

void PulseLines::end() {
  for (Line& line : lines_) line.knots.push_back({line.end_ns, static_cast<double>(line.count)});
}

std::array<double, drive::kArmAxes> PulseLines::at(double time_ns) {
  std::array<double, drive::kArmAxes> counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = at(lines_[i], time_ns);
  return counts;
}

double PulseLines::at(Line& line, double time_ns) {
  while (line.next < line.knots.size() && line.knots[line.next].time_ns < time_ns) ++line.next;
  if (line.next == 0) return line.knots.front().count;
  if (line.next == line.knots.size()) return line.knots.back().count;
  const Knot& a = line.knots[line.next - 1];
  const Knot& b = line.knots[line.next];
  return a.count + (b.count - a.count) * (time_ns - a.time_ns) / (b.time_ns - a.time_ns);
}

}  // namespace kerf::machine
