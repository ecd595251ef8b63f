#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace kerf::gcode {

/// Words that are no addresses.
enum class Keyword : std::uint8_t {
  none,
  // statements
  go_to,
  if_,
  then,
  while_,
  do_,
  end,
  popen,
  pclos,
  bprnt,
  dprnt,
  setvn,
  // operators
  and_,
  or_,
  xor_,
  mod,
  eq,
  ne,
  gt,
  ge,
  lt,
  le,
  // functions
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sqrt,
  abs,
  bin,
  bcd,
  round,
  fix,
  fup,
  ln,
  exp,
  pow,
  adp,
  prm
};

struct KeywordMatch {
  Keyword keyword = Keyword::none;
  std::size_t length = 0;  ///< bytes of the text that belong to it
};

/// The keyword at the beginning of `text`, in either case. Besides the whole word the control takes
/// its first two letters: WH, GO, EN, SQ, RO (and SQR, RND).
[[nodiscard]] KeywordMatch statement_at(std::string_view text);
[[nodiscard]] KeywordMatch operator_at(std::string_view text);
[[nodiscard]] KeywordMatch function_at(std::string_view text);

/// All of them, each in its longest spelling.
[[nodiscard]] std::span<const std::string_view> key_words();

}  // namespace kerf::gcode
