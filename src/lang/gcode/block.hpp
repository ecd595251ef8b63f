#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lang/vm/code_page.hpp"

namespace kerf::gcode {

/// One address word of a block with its value.
struct Word {
  double value = 0;  ///< as written; while compiled and `from_register`: the register's number
  char letter = 0;   ///< 'A' to 'Z', or ',' combined codes below
  std::uint8_t flags = 0;  ///< WordFlag bits
  vm::Span text{};         ///< where it stands on its line

  [[nodiscard]] bool has(std::uint8_t flag) const { return (flags & flag) != 0; }
};

/// How a word was written; what it means is the control's business.
struct WordFlag {
  static constexpr std::uint8_t literal = 1;        ///< digits, not a variable or bracket
  static constexpr std::uint8_t point = 2;          ///< a literal with a decimal point
  static constexpr std::uint8_t minus = 4;          ///< a literal with a minus sign
  static constexpr std::uint8_t from_register = 8;  ///< value to be fetched when the block runs
  static constexpr std::uint8_t comma = 16;         ///< ",R" ",C" ",A"
  static constexpr std::uint8_t many_digits = 32;   ///< more significant digits than a double holds
};

/// An executable NC block: its words in the order of the text, null words dropped. A view: valid
/// only while the control executes it.
struct Block {
  std::span<const Word> words;
  std::uint32_t line = 0;
  std::string_view name;     ///< "<NAME>" of a call by program name
  std::string_view comment;  ///< the block's first comment, without its parentheses
};

}  // namespace kerf::gcode
