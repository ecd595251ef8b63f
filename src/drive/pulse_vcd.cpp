#include "drive/pulse_vcd.hpp"

#include <algorithm>
#include <limits>

#include "base/decimal.hpp"

namespace kerf::drive {
namespace {

std::size_t step_wire(std::size_t axis) { return 2 * axis; }
std::size_t direction_wire(std::size_t axis) { return 2 * axis + 1; }

}  // namespace

PulseVcd::PulseVcd(const std::vector<std::string>& axis_names, std::int64_t direction_setup_ns,
                   base::OutputFile& file)
    : setup_ns_(direction_setup_ns), file_(file), axes_(axis_names.size()) {
  held_.reserve(64);
  header(axis_names);
}

void PulseVcd::header(const std::vector<std::string>& axis_names) {
  std::string values;
  line_ = "$timescale 1 ns $end\n$scope module kerf $end\n";
  for (std::size_t wire = 0; wire < 2 * axis_names.size(); ++wire) {
    const bool step = wire % 2 == 0;
    codes_.emplace_back(1, static_cast<char>('!' + wire));
    line_ += "$var wire 1 " + codes_.back() + ' ' + axis_names[wire / 2] +
             (step ? "_step" : "_dir") + " $end\n";
    values += (step ? '0' : '1') + codes_.back() + '\n';
  }
  line_ += "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n" + values + "$end\n";
  file_.write(line_);
}

void PulseVcd::take(const Pulse& pulse) {
  const std::size_t axis = index(pulse.axis);
  AxisState& state = axes_[axis];
  // A later pulse may still turn its direction from here on.
  write_until(pulse.time_ns - setup_ns_);
  if (pulse.direction != state.direction) {
    const std::int64_t settled = std::max(pulse.time_ns - setup_ns_, state.last_fall_ns);
    add(std::min(settled, pulse.time_ns), direction_wire(axis),
        pulse.direction == Direction::positive);
    state.direction = pulse.direction;
  }
  state.last_fall_ns = pulse.time_ns + pulse.width_ns;
  add(pulse.time_ns, step_wire(axis), true);
  add(state.last_fall_ns, step_wire(axis), false);
}

void PulseVcd::finish() { write_until(std::numeric_limits<std::int64_t>::max()); }

bool PulseVcd::later(const Change& a, const Change& b) {
  return a.time_ns != b.time_ns ? a.time_ns > b.time_ns : a.number > b.number;
}

void PulseVcd::add(std::int64_t time_ns, std::size_t wire, bool high) {
  held_.push_back({time_ns, changes_++, static_cast<std::uint32_t>(wire), high});
  std::push_heap(held_.begin(), held_.end(), later);
}

// Excludes `time_ns` itself: a change may still be added there.
void PulseVcd::write_until(std::int64_t time_ns) {
  while (!held_.empty() && held_.front().time_ns < time_ns) {
    write(held_.front());
    std::pop_heap(held_.begin(), held_.end(), later);
    held_.pop_back();
  }
}

void PulseVcd::write(const Change& change) {
  line_.clear();
  if (change.time_ns > written_ns_) {
    written_ns_ = change.time_ns;
    line_ += '#';
    base::append_integer(line_, written_ns_);
    line_ += '\n';
  }
  line_ += change.high ? '1' : '0';
  line_ += codes_[change.wire];
  line_ += '\n';
  file_.write(line_);
}

}  // namespace kerf::drive
