#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/block_id.hpp"
#include "base/diagnostic_code.hpp"
#include "base/place.hpp"

namespace kerf::base {

enum class Severity : std::uint8_t { error, warning, note };

/// One sentence about one place. Value type; printing is the business of whoever collects it.
struct Diagnostic {
  Severity severity = Severity::error;
  Code code{};
  std::string number;  ///< as printed: text_of(code).number, or the number of a user alarm (MC3005)
  std::string message;  ///< the control's words, then what is wrong here with the values
  Place place;
  std::string program;  ///< "O0001" or a program's name; empty outside of programs
  std::string hint;     ///< what was probably meant; may be empty
  std::optional<std::uint64_t> offset{};  ///< of a byte from 0, in files that are no text
  /// That was executed, or whose motion was made; none, where the text was only read.
  BlockId block{};
};

/// A diagnostic with the control's own words followed by `detail` (which may be empty).
[[nodiscard]] Diagnostic make_error(Code code, const Place& place, const std::string& detail = {},
                                    const std::string& hint = {});

}  // namespace kerf::base
