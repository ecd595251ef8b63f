#include "machine/dialect/internal/line_words.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "base/text_window.hpp"
#include "lang/gcode/language.hpp"
#include "lang/gcode/lexer.hpp"

namespace kerf::machine {
namespace {

using base::TokenKind;

bool is_address(TokenKind kind) {
  return kind == TokenKind::command || kind == TokenKind::switching ||
         kind == TokenKind::dimension || kind == TokenKind::technology;
}

bool is_word(const base::Token& token, std::string_view text) {
  return is_address(token.kind) && gcode::is_letter(gcode::Cursor::fold(text[0]));
}

bool stands_behind_comma(std::string_view line, const base::Token& token) {
  return token.begin > 0 && line[token.begin - 1] == ',';
}

LookedAtWord word_of(std::string_view text) {
  return {gcode::Cursor::fold(text[0]), base::read_number(text.substr(1)).value_or(0), text};
}

}  // namespace

LineWords::LineWords(std::string_view marked) {
  const std::string_view line = base::without_byte_order_mark(marked);
  for (const base::Token& token : base::tokens_of(gcode::language(), line)) {
    const std::string_view text = line.substr(token.begin, token.length);
    if (text == ";") return;
    if (!is_word(token, text) || stands_behind_comma(line, token)) continue;
    words_.push_back(word_of(text));
    letters_ |= bit(words_.back().letter);
  }
}

const LookedAtWord* LineWords::find(char letter) const {
  const auto found = std::find_if(words_.rbegin(), words_.rend(),
                                  [&](const LookedAtWord& word) { return word.letter == letter; });
  return found == words_.rend() ? nullptr : &*found;
}

bool LineWords::has_any(std::string_view letters) const {
  return std::any_of(letters.begin(), letters.end(), [&](char letter) { return has(letter); });
}

bool LineWords::has_all(std::string_view letters) const {
  return std::all_of(letters.begin(), letters.end(), [&](char letter) { return has(letter); });
}

const LookedAtWord* LineWords::find_code(int number) const {
  const auto found = std::find_if(words_.begin(), words_.end(), [&](const LookedAtWord& word) {
    return word.letter == 'G' && code_number(word.value, 10) == number;
  });
  return found == words_.end() ? nullptr : &*found;
}

std::optional<std::int64_t> code_number(double value, int scale) {
  constexpr double kMost = 100'000;
  const double number = value * scale;
  if (!(number >= 0 && number < kMost && number == std::floor(number))) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

}  // namespace kerf::machine
