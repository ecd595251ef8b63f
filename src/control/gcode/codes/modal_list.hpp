#pragma once

#include <string>
#include <vector>

#include "control/core/control.hpp"

namespace kerf::control {

/// What a control of G-code shows of its modes: one code a group, and the offsets that are on.
[[nodiscard]] std::vector<std::string> modal_list(const ModalView& modal);

}  // namespace kerf::control
