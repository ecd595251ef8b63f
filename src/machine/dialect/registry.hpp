#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/language.hpp"
#include "base/source_file.hpp"
#include "control/core/parameters.hpp"
#include "control/gcode/codes/code_table.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {

/// The dialect of patterns, whose programs are pulses and no motions that a servo plans.
inline constexpr const char* kPatternDialect = "pattern";

/// What a run is called that makes motions which were planned: no language of programs.
inline constexpr const char* kDrawingDialect = "drawing";
/// The dialect of motion records.
inline constexpr const char* kMotionDialect = "motion";

/// A dialect that Kerf runs: a language, and what executes it.
struct DialectRow {
  enum class Kind : std::uint8_t { gcode, basic, teach, motion, pattern };

  Kind kind{};
  std::string_view name;  ///< of kDialects
  const base::Language* language = nullptr;
  std::string_view machine;  ///< built-in one that runs it where none is named; machine_for()
  /// Of G-code: what its codes mean.
  const control::CodeTable& (*codes)(const control::Parameters&) = nullptr;
};

/// All of them, the usual one first.
[[nodiscard]] std::span<const DialectRow> dialects();
[[nodiscard]] inline const DialectRow& usual_dialect() { return dialects().front(); }
[[nodiscard]] std::vector<std::string_view> dialect_names();
/// Names of those whose programs are texts: of a pattern a replay runs the bytes.
[[nodiscard]] std::vector<std::string_view> text_dialects();
/// Null: Kerf does not run it.
[[nodiscard]] const DialectRow* find_dialect(std::string_view name);

// Which dialect a program is in, as far as it shows; otherwise that of its machine.

/// By the ending of a file: `.bas`, `.tch`, `.jsonl`, `.pat`. Null: any, G-code above all.
[[nodiscard]] const DialectRow* dialect_by_ending(const std::string& path);
/// By the first line that only one language has. Null: no such line comes before one of any
/// language, or within 4 KiB.
[[nodiscard]] const DialectRow* dialect_by_text(const base::SourceFile& program);
/// By its ending, else by its text. Empty: it does not show.
[[nodiscard]] std::string dialect_shown_by(const base::SourceFile& program);
/// Whether a file is pattern bytes by its ending. A control runs their listing, a replay the bytes.
[[nodiscard]] bool ends_as_pattern(const std::string& path);

}  // namespace kerf::machine
