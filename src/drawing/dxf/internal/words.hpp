#pragma once

#include <string>
#include <string_view>

namespace kerf::drawing::dxf {

/// What a TEXT says, of UTF-8 with its codes: %%c is Ø, %%d °, %%p ±, %%% a percent sign, %%065 the
/// character of that number; lines below and above (%%u, %%o, %%k) are left out.
[[nodiscard]] std::string words_of_text(std::string_view coded);
/// What an MTEXT says: \P is a new line, a stacked fraction is written with a slash, all that only
/// says how it looks is left out; and what words_of_text() does.
[[nodiscard]] std::string words_of_mtext(std::string_view coded);

}  // namespace kerf::drawing::dxf
