#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/language.hpp"

namespace kerf::features {

/// A letter and the value behind it, as they stand in a block. Bytes of the block, from 0.
struct BlockWord {
  char letter = 0;          ///< in capitals
  std::string value{};      ///< without blanks and comments, in capitals
  std::uint32_t begin = 0;  ///< of the letter
  std::uint32_t end = 0;    ///< behind the last byte of the value
  bool is_literal = true;   ///< a number; else a variable or an expression

  [[nodiscard]] std::optional<double> number() const;
  /// Where its digits begin, sign included.
  [[nodiscard]] std::uint32_t value_begin() const { return begin + 1; }
};

/// The words of a block of G-code, in their order; what is no word is left out.
[[nodiscard]] std::vector<BlockWord> words_of(const base::Language& language,
                                              std::string_view block);
[[nodiscard]] const BlockWord* find(const std::vector<BlockWord>& words, char letter);

}  // namespace kerf::features
