#include "control/core/offset_parts.hpp"

#include <cmath>

namespace kerf::control {
namespace {

using Tool = ToolOffset;
using Turning = TurningOffset;

constexpr OffsetPart<Tool> kToolParts[] = {
    {"length_geometry", [](Tool& row) -> double& { return row.length_geometry; }},
    {"length_wear", [](Tool& row) -> double& { return row.length_wear; }},
    {"radius_geometry", [](Tool& row) -> double& { return row.radius_geometry; }},
    {"radius_wear", [](Tool& row) -> double& { return row.radius_wear; }}};

constexpr int kMostTip = 9;

constexpr OffsetPart<Turning> kTurningParts[] = {
    {"geometry_x", [](Turning& row) -> double& { return row.geometry.x; }},
    {"geometry_z", [](Turning& row) -> double& { return row.geometry.z; }},
    {"geometry_y", [](Turning& row) -> double& { return row.geometry.y; }},
    {"geometry_radius", [](Turning& row) -> double& { return row.geometry.radius; }},
    {"wear_x", [](Turning& row) -> double& { return row.wear.x; }},
    {"wear_z", [](Turning& row) -> double& { return row.wear.z; }},
    {"wear_y", [](Turning& row) -> double& { return row.wear.y; }},
    {"wear_radius", [](Turning& row) -> double& { return row.wear.radius; }},
    {"tip", [](Turning& row) -> double& { return row.tip; }, kMostTip}};

}  // namespace

template <typename Row>
bool OffsetPart<Row>::takes(double value) const {
  if (most_whole == 0) return std::isfinite(value);
  return value == std::floor(value) && value >= 0 && value <= most_whole;
}

template struct OffsetPart<Tool>;
template struct OffsetPart<Turning>;

std::span<const OffsetPart<Tool>> parts_of(const Tool& /*row*/) { return kToolParts; }
std::span<const OffsetPart<Turning>> parts_of(const Turning& /*row*/) { return kTurningParts; }

}  // namespace kerf::control
