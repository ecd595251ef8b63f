#pragma once

#include <span>
#include <string_view>

#include "control/core/memory.hpp"

namespace kerf::control {

/// A number of an offset by the name that files and commands have for it.
template <typename Row>
struct OffsetPart {
  std::string_view name;
  double& (*of)(Row& row);
  /// 0: any number of mm; else a whole number from 0 to this.
  int most_whole = 0;

  [[nodiscard]] double value(Row row) const { return of(row); }
  [[nodiscard]] bool takes(double value) const;
};

/// "length_geometry", "length_wear", "radius_geometry", "radius_wear".
[[nodiscard]] std::span<const OffsetPart<ToolOffset>> parts_of(const ToolOffset& row);
/// "geometry_x" _z _y _radius, "wear_x" _z _y _radius, "tip".
[[nodiscard]] std::span<const OffsetPart<TurningOffset>> parts_of(const TurningOffset& row);

/// Null: such an offset has no part of this name.
template <typename Row>
[[nodiscard]] const OffsetPart<Row>* part_named(std::string_view name) {
  for (const OffsetPart<Row>& part : parts_of(Row{}))
    if (part.name == name) return &part;
  return nullptr;
}

}  // namespace kerf::control
