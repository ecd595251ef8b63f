#pragma once

#include <cstdint>
#include <optional>

#include "control/core/memory.hpp"
#include "control/core/work_system.hpp"
#include "control/gcode/frames/transform.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::control {

/// The tip of a tool that stands on the programmed path: no compensation acts.
[[nodiscard]] inline base::TipPoint on_path(const base::PathPoint& path) {
  return base::TipPoint(path.numbers());
}

/// Where the programmed point is, in every coordinate system at once (docs/dialect.md §8.3):
///
///   path = transform(program) + origin,     origin = EXT + work offset + G52 shift + G92 shift
///   machine = path + length offset
///
/// `program` is what the words of the program say (#5001), `path` the same point in the machine's
/// coordinate system without tool length. mm and degrees: what programs and offsets say as a
/// diameter is halved where it is read.
class Coordinates {
 public:
  /// At power-on G54 is in force with the offset that the memory has kept.
  Coordinates(const motion::AxisSetup& axes, const Memory& memory)
      : axes_(&axes),
        memory_(&memory),
        program_(axes.start.numbers()),
        path_(axes.start.numbers()) {
    refresh_origin();
  }

  [[nodiscard]] const base::ProgramPoint& program() const { return program_; }
  [[nodiscard]] const base::PathPoint& path() const { return path_; }
  [[nodiscard]] const base::AxisVector& length() const { return length_; }
  [[nodiscard]] const base::AxisVector& origin() const { return origin_; }
  [[nodiscard]] const WorkSystem& work() const { return work_; }
  [[nodiscard]] const Transform& transform() const { return transform_; }

  /// The point of the machine's coordinate system where a programmed point lies.
  [[nodiscard]] base::PathPoint path_of(const base::ProgramPoint& program) const;
  /// With the lengths in force.
  [[nodiscard]] base::MachinePoint machine_of(const base::TipPoint& tip) const {
    return base::machine_of(tip, length_);
  }
  /// The programmed point moves.
  void move_to(const base::ProgramPoint& program, const base::PathPoint& path) {
    program_ = program;
    path_ = path;
  }
  /// The tool has come to a point of the machine's coordinate system by other means than a
  /// programmed target (G28, G53, G31): the programmed point follows.
  void arrive_at(const base::PathPoint& path);
  void set_length(base::Axis axis, double offset) { length_[axis] = offset; }

  // Each of these leaves the tool where it is and gives the programmed point its new coordinates.
  void select(const WorkSystem& work);
  /// After a change of the offsets in memory.
  void offsets_changed();
  void set_local(base::Axis axis, double shift);
  /// G92: the programmed point reads `program` from now on.
  void preset(const base::ProgramPoint& program);
  /// G92.1: drops the G52 and G92 shifts of an axis.
  void clear_shifts(base::Axis axis);
  /// What presets have left: the shift of G92.
  [[nodiscard]] const base::AxisVector& shift() const { return shift_; }
  void set_shift(const base::AxisVector& shift) {
    shift_ = shift;
    refresh_origin();
  }
  void set_transform(const Transform& transform);

  /// A rotary axis counts mm of a surface from now on, `mm_per_degree` each; 0: mm from where it
  /// stands.
  void unroll(base::Axis axis, double mm_per_degree);
  /// It counts degrees again, and the tool stands at `path`.
  void roll_up(const base::PathPoint& path);

 private:
  void refresh_origin();
  [[nodiscard]] base::AxisVector image_of(const base::ProgramPoint& program) const;
  [[nodiscard]] base::ProgramPoint program_of(const base::AxisVector& image) const;
  [[nodiscard]] base::AxisVector tidied(base::AxisVector point) const;

  const motion::AxisSetup* axes_;
  const Memory* memory_;
  base::ProgramPoint program_;
  base::PathPoint path_;
  base::AxisVector length_;
  base::AxisVector local_;
  base::AxisVector shift_;
  base::AxisVector origin_;
  struct Unrolled {
    base::Axis axis{};
    double mm_per_degree = 0;
  };
  std::optional<Unrolled> unrolled_;
  WorkSystem work_;
  Transform transform_;
  bool plain_ = true;  // no transform, origin at machine zero: programmed points are machine points
};

}  // namespace kerf::control
