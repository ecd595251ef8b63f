#include "features/merge/block_words.hpp"

#include <algorithm>

#include "base/decimal.hpp"

namespace kerf::features {
namespace {

using base::TokenKind;

bool is_word(TokenKind kind) {
  return kind == TokenKind::command || kind == TokenKind::switching ||
         kind == TokenKind::dimension || kind == TokenKind::technology ||
         kind == TokenKind::sequence;
}

}  // namespace

std::optional<double> BlockWord::number() const {
  if (!is_literal) return std::nullopt;
  const auto read = base::read_number(value);
  return read ? std::optional(*read) : std::nullopt;
}

std::vector<BlockWord> words_of(const base::Language& language, std::string_view block) {
  std::vector<BlockWord> words;
  for (const base::Token& token : base::tokens_of(language, block)) {
    if (token.kind == TokenKind::blank || token.kind == TokenKind::comment) continue;
    const std::string piece = base::capitals(std::string(block.substr(token.begin, token.length)));
    if (piece.empty()) continue;
    const bool begins = is_word(token.kind) && piece[0] >= 'A' && piece[0] <= 'Z';
    if (begins) {
      words.push_back({piece[0], piece.substr(1), token.begin, token.begin + token.length, true});
    } else if (!words.empty()) {
      words.back().value += piece;
      words.back().end = token.begin + token.length;
      words.back().is_literal = words.back().is_literal && is_word(token.kind);
    }
  }
  return words;
}

const BlockWord* find(const std::vector<BlockWord>& words, char letter) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const BlockWord& word) { return word.letter == letter; });
  return found == words.end() ? nullptr : &*found;
}

}  // namespace kerf::features
