#include "lang/teach/language.hpp"

#include <array>

#include "lang/teach/record_parser.hpp"

namespace kerf::teach {
namespace {

using base::TokenKind;

constexpr std::array<std::string_view, 1> kEndings = {".tch"};

bool shows(const base::FirstWord& first) { return first.word == "TEACH"; }

void cut(std::string_view line, std::vector<base::Token>& tokens) {
  base::TokenRow row(line, tokens);
  const auto next = [&] { return row.next_word(kBetweenWords, kCommentMark); };
  const std::string_view head = next();
  std::size_t number = 0;
  for (std::string_view word = head; !word.empty(); word = next())
    row.put(kind_of_word(head, number++, word), word.data() + word.size());
  row.put(TokenKind::comment, row.end());
}

}  // namespace

const base::Language& language() {
  static const base::Language language = {.name = "teach",
                                          .endings = kEndings,
                                          .shows_by_word = shows,
                                          .comment = {";"},
                                          .key_words = key_words(),
                                          .example = "POINT 300 0 50 0 0",
                                          .cut = cut};
  return language;
}

}  // namespace kerf::teach
