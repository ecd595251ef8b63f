#include "output/records/set_point_csv.hpp"

#include "base/decimal.hpp"

namespace kerf::output {

SetPointCsv::SetPointCsv(const machine::MachineDefinition& machine, base::OutputFile& file)
    : file_(file),
      axes_(machine.axes.count()),
      joints_(machine.driven.size()),
      laser_(machine.drive.laser.fitted()) {
  for (std::size_t i = 0; i < axes_; ++i) counts_[i] = machine.axes.axes[i].count_per_mm();
  header(machine);
}

void SetPointCsv::header(const machine::MachineDefinition& machine) {
  row_ = "t";
  for (const motion::AxisConfig& axis : machine.axes.axes) {
    row_ += ',';
    row_ += axis.letter;
  }
  if (laser_) row_ += ",power";
  for (std::size_t joint = 1; joint <= joints_; ++joint) row_ += ",j" + std::to_string(joint);
  row_ += ",line\n";
  file_.write(row_);
}

void SetPointCsv::Cell::set(double number) {
  if (number == value) return;
  value = number;
  text.clear();
  base::append_number(text, number);
}

void SetPointCsv::append(const Cell& cell) {
  row_ += ',';
  row_ += cell.text;
}

void SetPointCsv::append_joint(std::size_t joint, double value) {
  const bool is_tip = value == tip_cells_[joint].value;
  if (!is_tip) joint_cells_[joint].set(value);
  append(is_tip ? tip_cells_[joint] : joint_cells_[joint]);
}

void SetPointCsv::take(const motion::AxisPoint& point) {
  row_.clear();
  base::append_number(row_, base::tidy(point.tip.time_s));
  for (std::size_t i = 0; i < axes_; ++i) {
    tip_cells_[i].set(point.tip.tip.values[i] * counts_[i]);
    append(tip_cells_[i]);
  }
  if (laser_) {
    if (point.power_percent != power_percent_) power_.set(base::decimal_of(point.power_percent));
    power_percent_ = point.power_percent;
    append(power_);
  }
  for (std::size_t i = 0; i < joints_; ++i) append_joint(i, point.joints.values[i]);
  row_ += ',';
  base::append_integer(row_, point.tip.mark.block.line);
  row_ += '\n';
  file_.write(row_);
}

}  // namespace kerf::output
