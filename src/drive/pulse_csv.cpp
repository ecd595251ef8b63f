#include "drive/pulse_csv.hpp"

#include "base/decimal.hpp"

namespace kerf::drive {

PulseCsv::PulseCsv(const std::vector<std::string>& axis_names, base::OutputFile& file)
    : file_(file) {
  for (const std::string& name : axis_names) {
    ends_.push_back("," + name + ",-1\n");
    ends_.push_back("," + name + ",1\n");
  }
  file_.write("time_ns,axis,direction\n");
}

void PulseCsv::take(const Pulse& pulse) {
  const std::size_t positive = pulse.direction == Direction::positive ? 1 : 0;
  line_.clear();
  base::append_integer(line_, pulse.time_ns);
  line_ += ends_[2 * index(pulse.axis) + positive];
  file_.write(line_);
}

}  // namespace kerf::drive
