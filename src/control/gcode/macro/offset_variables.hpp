#pragma once

#include <cstdint>

#include "control/gcode/acts/state.hpp"

namespace kerf::control {

/// Which place of the memory a system variable of an offset names (docs/dialect/macros.md §3.4 to
/// §3.6). Lathes have other numbers than machining centres.
class OffsetVariables {
 public:
  struct Place {
    double* value = nullptr;  ///< null: the variable is none of these
    bool is_length = true;    ///< counts mm; else it is a number as such
    explicit operator bool() const { return value != nullptr; }
  };

  explicit OffsetVariables(State& state) : state_(state) {}

  /// EXT, G54 to G59, G54.1 P.
  [[nodiscard]] Place work(std::uint32_t number);
  /// A part of a row of the tool offset table.
  [[nodiscard]] Place tool(std::uint32_t number);

 private:
  [[nodiscard]] Place milling_tool(std::uint32_t number);
  [[nodiscard]] Place turning_tool(std::uint32_t number);
  [[nodiscard]] bool turns() const { return state_.codes.habits().tool_brings_offset; }

  State& state_;
};

}  // namespace kerf::control
