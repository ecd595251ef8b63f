#pragma once

#include <cstdint>

#include "control/core/memory.hpp"

namespace kerf::output {

/// What the control's tables say of the tools of a lathe while they are at work.
struct ToolTable {
  const control::Memory* memory = nullptr;  ///< null: nothing is known
  bool geometry_by_tool = false;            ///< LGN

  /// Of a tool with the offset that T has brought.
  [[nodiscard]] control::Nose nose(std::uint32_t tool, std::uint32_t offset) const {
    return memory == nullptr ? control::Nose{}
                             : memory->nose(offset, geometry_by_tool ? tool : offset);
  }
  /// Of a drill, mm; 0: not known.
  [[nodiscard]] double radius(std::uint32_t tool) const {
    const bool has = memory != nullptr && tool < memory->tools.size();
    return has ? memory->tools[tool].radius_geometry : 0;
  }
};

}  // namespace kerf::output
