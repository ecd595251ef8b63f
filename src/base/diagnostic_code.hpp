#pragma once

#include <cstdint>
#include <string_view>

namespace kerf::base {

/// What a diagnostic is about. One enumerator per row of diagnostic_codes.def.
enum class Code : std::uint16_t {
#define CODE(name, number, message, cause_and_remedy) name,
#include "base/diagnostic_codes.def"
#undef CODE
};

/// A row of the table of diagnostics.
struct CodeText {
  std::string_view name;     ///< the enumerator
  std::string_view number;   ///< "PS0112", or a name in capitals where the control has no number
  std::string_view message;  ///< the control's own words
  std::string_view cause;    ///< what it means
  std::string_view remedy;   ///< what to do; empty where the cause says it
};

[[nodiscard]] const CodeText& text_of(Code code);

}  // namespace kerf::base
