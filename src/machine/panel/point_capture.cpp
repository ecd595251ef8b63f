#include "machine/panel/point_capture.hpp"

#include "base/decimal.hpp"
#include "machine/dialect/taught_for.hpp"

namespace kerf::machine {

teach::Pose captured_pose(const kinematics::Kinematics& kinematics, const motion::AxisSetup& axes,
                          const base::JointPoint& joints) {
  const base::TipPoint tip = kinematics.forward(joints);
  const auto value = [&](char letter) {
    const auto axis = axes.find(letter);
    return axis ? tip[*axis] : 0;
  };
  return {value('X'), value('Y'), value('Z'), value('A'), value('C')};
}

teach::Recorder new_recorder(const MachineDefinition& machine) {
  const control::TaughtFor self = taught_for(machine);
  return teach::Recorder({self.period_ms}, self.radii);
}

Capture::Capture(const MachineDefinition& machine)
    : kinematics_(machine.make_kinematics()),
      axes_(machine.axes),
      recorder_(new_recorder(machine)) {}

std::optional<teach::Mistake> Capture::point(const base::JointPoint& joints,
                                             std::string_view name) {
  if (name.size() > teach::Name::kMost)
    return teach::Mistake{base::Code::teach_range,
                          "a name has at most " + std::to_string(teach::Name::kMost) + " bytes",
                          {}};
  return recorder_.teach(teach::Point{pose_at(joints), teach::Name(name)});
}

std::optional<teach::Mistake> Capture::line(const base::JointPoint& joints) {
  return recorder_.teach(teach::Line{pose_at(joints)});
}

template <typename Move>
std::optional<teach::Mistake> Capture::through_middle(const base::JointPoint& joints) {
  if (!middle_)
    return teach::Mistake{base::Code::teach_order, "the second of its three points is missing", {}};
  auto refused = recorder_.teach(Move{*middle_, pose_at(joints)});
  if (!refused) middle_.reset();
  return refused;
}

std::optional<teach::Mistake> Capture::arc(const base::JointPoint& joints) {
  return through_middle<teach::Arc>(joints);
}

std::optional<teach::Mistake> Capture::circle(const base::JointPoint& joints) {
  return through_middle<teach::Circle>(joints);
}

bool Capture::take_back() {
  if (!middle_) return recorder_.take_back();
  middle_.reset();
  return true;
}

}  // namespace kerf::machine
