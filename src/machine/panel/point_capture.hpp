#pragma once

#include "kinematics/kinematics.hpp"
#include "lang/teach/recorder.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::machine {

/// Where the beam is while the joints stand somewhere, as the teach key wants it: the focus (of a
/// head: what its carriage and both radii make of it, docs/kinematics.md) with A and C. An axis
/// that the program of this machine does not have is 0. `joints` in the order of the machine file.
[[nodiscard]] teach::Pose captured_pose(const kinematics::Kinematics& kinematics,
                                        const motion::AxisSetup& axes,
                                        const base::JointPoint& joints);

/// Period and radii of a machine, with which a taught program begins.
[[nodiscard]] teach::Recorder new_recorder(const MachineDefinition& machine);

/// The teach keys of a panel: point, line and arc from where the machine stands. The middle of an
/// arc is captured first and waits for its end.
///
///   Capture capture(machine);
///   capture.point(joints, "edge");   // POINT x y z a c edge
///   capture.middle(joints);          // nothing yet
///   capture.arc(joints);             // ARC x2 … c2 x3 … c3
///
/// Each key answers why the record is refused, or nothing; then nothing has changed.
class Capture {
 public:
  explicit Capture(const MachineDefinition& machine);

  [[nodiscard]] std::optional<teach::Mistake> point(const base::JointPoint& joints,
                                                    std::string_view name = {});
  [[nodiscard]] std::optional<teach::Mistake> line(const base::JointPoint& joints);
  /// The second point of an ARC or CIRCLE; a second key press replaces it.
  void middle(const base::JointPoint& joints) { middle_ = pose_at(joints); }
  [[nodiscard]] std::optional<teach::Mistake> arc(const base::JointPoint& joints);
  [[nodiscard]] std::optional<teach::Mistake> circle(const base::JointPoint& joints);
  /// FEED, LASER, DWELL, END.
  [[nodiscard]] std::optional<teach::Mistake> add(const teach::Record& record) {
    return recorder_.teach(record);
  }
  /// Forgets the middle that waits, or else the last record. False: there is neither.
  bool take_back();

  [[nodiscard]] teach::Pose pose_at(const base::JointPoint& joints) const {
    return captured_pose(*kinematics_, axes_, joints);
  }
  [[nodiscard]] const std::optional<teach::Pose>& waiting_middle() const { return middle_; }
  [[nodiscard]] const teach::Recorder& recorder() const { return recorder_; }

 private:
  template <typename Move>
  std::optional<teach::Mistake> through_middle(const base::JointPoint& joints);

  std::unique_ptr<const kinematics::Kinematics> kinematics_;
  motion::AxisSetup axes_;
  teach::Recorder recorder_;
  std::optional<teach::Pose> middle_;
};

}  // namespace kerf::machine
