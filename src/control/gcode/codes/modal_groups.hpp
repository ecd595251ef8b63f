#pragma once

#include <span>
#include <string_view>

#include "control/gcode/codes/code_table.hpp"

namespace kerf::control {

/// A group of modal codes and what it is called.
struct ModalGroup {
  Group group{};
  std::string_view name;  ///< "motion"
};

/// All groups in the order in which an operator looks for them.
[[nodiscard]] std::span<const ModalGroup> modal_groups();

/// Whether a modal code says that nothing special is on: what is in force at power-on and
/// millimetres. What moves and where points count from are always worth a look.
[[nodiscard]] bool says_nothing_special(const CodeRow& row);

}  // namespace kerf::control
