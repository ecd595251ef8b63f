#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/text_stretch.hpp"

namespace kerf::output {

/// What stretches make of a text, as a unified diff with three lines of context, for `patch -p1`:
/// of a/NAME and b/NAME, a path from the root without its slash. Lines end at LF; a last line
/// without one is told. Empty: nothing changes. Takes time by the length of the text, however many
/// stretches there are.
[[nodiscard]] std::string unified_diff(const std::string& name, std::string_view before,
                                       std::span<const base::TextStretch> stretches);

}  // namespace kerf::output
