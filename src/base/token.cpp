#include "base/token.hpp"

#include <algorithm>
#include <array>

namespace kerf::base {

std::string_view name_of(TokenKind kind) {
  constexpr std::array<std::string_view, 18> kNames = {
      "blank",     "comment",   "program",    "sequence", "skip",     "command",
      "switching", "dimension", "technology", "keyword",  "function", "operator",
      "variable",  "number",    "text",       "label",    "target",   "error"};
  return kNames[static_cast<std::size_t>(kind)];
}

void TokenRow::put(TokenKind kind, const char* end) {
  const auto stop = static_cast<std::size_t>(end - line_.data());
  if (stop <= done_) return;
  tokens_.push_back(
      {kind, static_cast<std::uint32_t>(done_), static_cast<std::uint32_t>(stop - done_)});
  done_ = stop;
}

std::string_view TokenRow::next_word(std::string_view blanks, char comment) {
  const auto is_blank = [&](char c) { return blanks.find(c) != std::string_view::npos; };
  const char* const begin = std::find_if_not(at(), end(), is_blank);
  put(TokenKind::blank, begin);
  const char* const stop =
      std::find_if(begin, end(), [&](char c) { return c == comment || is_blank(c); });
  return {begin, static_cast<std::size_t>(stop - begin)};
}

}  // namespace kerf::base
