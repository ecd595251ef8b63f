#pragma once

#include <cstdint>

#include "control/gcode/codes/modal_state.hpp"
#include "control/gcode/words/words.hpp"

namespace kerf::control {

/// The words of a block that mean nothing there: P, L, Q, R, I, J and K belong to some codes only,
/// and the control passes over them elsewhere. One bit for each letter (Words::mask). `modal` is
/// the state in which the block is executed, `calls` that it calls a program or returns.
[[nodiscard]] std::uint32_t idle_words(const Words& words, const ModalState& modal, bool calls);

}  // namespace kerf::control
