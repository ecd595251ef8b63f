#pragma once

#include <string>
#include <string_view>

namespace kerf::drawing {

/// What stands for bytes that are no character.
inline constexpr char32_t kNoCharacter = 0xFFFD;

/// The character at `at`, which goes on behind it; a byte that begins none is kNoCharacter.
[[nodiscard]] char32_t take_character(std::string_view text, std::size_t& at);
[[nodiscard]] std::string as_utf8(char32_t code);

}  // namespace kerf::drawing
