#pragma once

#include <array>
#include <limits>
#include <string>

#include "base/output_file.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/axis_point.hpp"

namespace kerf::output {

/// Writes set-points as CSV, a row each: `t,X,Y,Z,A,C,power,j1,j2,…,line`, with the columns that
/// the machine has.
///
/// t in s; the tip as the records of motions have it, X of a lathe as a diameter, while the driven
/// axis has its own way, the radius; the laser's power in percent; the driven axes in the order
/// of the machine file; the source line of the motion that is under way or ends there. The start is
/// no row: the first one is a period behind it. Nothing is allocated per row.
class SetPointCsv : public motion::AxisPointSink {
 public:
  /// The file must outlive the writer.
  SetPointCsv(const machine::MachineDefinition& machine, base::OutputFile& file);
  void take(const motion::AxisPoint& point) override;

 private:
  /// A number and its text: what stands still, or stands where the tip does, is not converted anew.
  struct Cell {
    double value = std::numeric_limits<double>::quiet_NaN();
    std::string text;

    void set(double number);
  };
  using Cells = std::array<Cell, base::kMaxAxes>;

  void header(const machine::MachineDefinition& machine);
  void append(const Cell& cell);
  void append_joint(std::size_t joint, double value);

  base::OutputFile& file_;
  std::size_t axes_;
  std::size_t joints_;
  bool laser_;
  std::array<double, base::kMaxAxes> counts_{};  // per axis: what its column counts for 1 mm
  Cells tip_cells_;
  Cells joint_cells_;
  float power_percent_ = -1;
  Cell power_;
  std::string row_;
};

}  // namespace kerf::output
