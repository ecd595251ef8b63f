#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/source_file.hpp"

namespace kerf::machine {

/// The dialect of patterns, whose programs are pulses and no motions that a servo plans.
inline constexpr const char* kPatternDialect = "pattern";

/// A language that shows in a program itself, and the machine that runs it where none is named.
struct Language {
  std::string_view dialect;
  std::string_view ending;
  std::string_view machine;
};

/// All of them.
[[nodiscard]] std::span<const Language> languages();
/// By the ending of a file: `.bas`, `.tch`, `.pat`. Nothing: any language, G-code above all.
[[nodiscard]] std::optional<Language> language_by_ending(const std::string& path);
/// By the first line that only one language has.
[[nodiscard]] std::optional<Language> language_by_text(const base::SourceFile& program);
/// Whether a file is pattern bytes by its ending. A control runs their listing, a replay the bytes.
[[nodiscard]] bool ends_as_pattern(const std::string& path);
/// Of a dialect; nothing: it is one of G-code.
[[nodiscard]] std::optional<Language> language_of(std::string_view dialect);

}  // namespace kerf::machine
