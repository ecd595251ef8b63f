#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace kerf::gcode {

/// A named system variable of the control: `[#_ABSMT[1]]` is #5021.
struct SystemName {
  std::string_view name;
  std::uint32_t first = 0;  ///< variable number of the lowest index
  std::uint32_t lowest_index = 0;
  std::uint32_t count = 1;
  bool indexed = false;
};

/// The variable that a name beginning with '_' stands for, or nothing.
[[nodiscard]] std::optional<SystemName> system_name(std::string_view name);

}  // namespace kerf::gcode
