#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stock/tool/tool_kind.hpp"

namespace kerf::machine {

/// Letters as capitals, so that words can be compared; other bytes as they are.
[[nodiscard]] std::string capitals(std::string_view text);

/// The kind of tool that a text in plain words names: "10mm carbide bullnose end mill". Of several
/// the most particular one. Null row: it names none.
[[nodiscard]] stock::NamedKind kind_in_words(std::string_view text);

/// The number behind a key where the text has one: `D` in "DRILL D6.8", "D=6.8", and in "Ø6.8",
/// `Ø` being read as `D` (UTF-8 or Latin-1). The key stands at the beginning of a word.
[[nodiscard]] std::optional<double> number_behind(std::string_view key, std::string_view text);

}  // namespace kerf::machine
