#include "machine/definition/work_turns.hpp"

#include <optional>

namespace kerf::machine {
namespace {

using stock::Vec3;

std::optional<Vec3> direction_of(char letter) {
  switch (letter) {
    case 'A': return Vec3{1, 0, 0};
    case 'B': return Vec3{0, 1, 0};
    case 'C': return Vec3{0, 0, 1};
    default: return std::nullopt;
  }
}

Vec3 in_space(const std::array<double, 3>& point) { return {point[0], point[1], point[2]}; }

}  // namespace

std::vector<stock::WorkTurn> work_turns(const MachineDefinition& machine) {
  std::vector<stock::WorkTurn> turns;
  if (machine.kinematics.kind != kinematics::Kind::cartesian) return turns;
  const kinematics::TablePoints& points = machine.kinematics.tables;
  for (std::size_t i = 0; i < machine.axes.count(); ++i) {
    const motion::AxisConfig& axis = machine.axes.axes[i];
    const auto direction = axis.rotary ? direction_of(axis.letter) : std::nullopt;
    if (!direction) continue;
    turns.push_back({.axis = base::Axis{static_cast<std::uint8_t>(i)},
                     .direction = *direction,
                     .point = in_space(turns.empty() ? points.primary : points.secondary)});
  }
  return turns;
}

}  // namespace kerf::machine
