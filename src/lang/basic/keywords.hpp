#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace kerf::basic {

/// The words of the language; those behind `function` are functions, those from `home` to `air`
/// tell the machine what to do.
enum class Word : std::uint8_t {
  none,
  let,
  print,
  input,
  if_,
  then,
  else_,
  for_,
  to,
  step,
  next,
  go_to,
  gosub,
  return_,
  end,
  home,
  speed,
  power,
  move,
  line,
  arc,
  circle,
  wait,
  burn,
  pulse,
  air,
  local,
  and_,
  or_,
  not_,
  rem,
  function,  ///< no word: where functions begin
  sin,
  cos,
  tan,
  atn,
  asin,
  acos,
  sqr,
  abs,
  int_,
  sgn,
  exp,
  log,
  atan2,
  min,
  max,
  mod,
  dist,
  xpos,
  ypos,
  zpos,
  moved,
  deg,
  rad
};

[[nodiscard]] constexpr bool is_function(Word word) { return word > Word::function; }

[[nodiscard]] constexpr bool is_command(Word word) {
  return word >= Word::home && word <= Word::air;
}

/// The word of this text in capitals; `none` when it is a name.
[[nodiscard]] Word word_of(std::string_view capitals);
/// All of them.
[[nodiscard]] std::span<const std::string_view> key_words();

}  // namespace kerf::basic
