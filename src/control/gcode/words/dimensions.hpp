#pragma once

#include "control/gcode/codes/modal_state.hpp"
#include "control/gcode/words/words.hpp"

namespace kerf::control {

/// What a block says of the line that it cuts, besides its end: words with a comma, of a lathe also
/// without one.
struct Dimensions {
  const gcode::Word* corner = nullptr;  ///< ",C" or ",R"; of a lathe also C, R, I or K
  const gcode::Word* angle = nullptr;   ///< ",A" or A, of a lathe

  [[nodiscard]] bool any() const { return corner != nullptr || angle != nullptr; }
  /// Precondition: any().
  [[nodiscard]] const gcode::Word& first() const { return corner != nullptr ? *corner : *angle; }
};

/// Whether the axis words of a block are those of a G01. `modal` is the state before the block or
/// the one in which it is executed.
[[nodiscard]] bool cuts_line(const Words& words, const ModalState& modal);

}  // namespace kerf::control
