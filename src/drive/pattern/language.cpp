#include "drive/pattern/language.hpp"

#include <algorithm>
#include <array>

#include "base/decimal.hpp"
#include "drive/pattern/axis_name.hpp"
#include "drive/pattern/listing.hpp"

namespace kerf::drive {
namespace {

using base::TokenKind;

constexpr std::array<std::string_view, 1> kEndings = {".pat"};
constexpr std::array kKeyWords = {kFastRecord, kSlowRecord, kLinkedRecord};

TokenKind kind_of_value(std::string_view word) {
  if (std::find(kArmAxisNames.begin(), kArmAxisNames.end(), word) != kArmAxisNames.end())
    return TokenKind::dimension;
  if (word[0] == '-' || word[0] == '+') word.remove_prefix(1);
  return base::read_whole_number(word) ? TokenKind::number : TokenKind::error;
}

TokenKind kind_of_head(std::string_view word) {
  const bool is_record = std::find(kKeyWords.begin(), kKeyWords.end(), word) != kKeyWords.end();
  return is_record ? TokenKind::command : TokenKind::error;
}

void cut(std::string_view line, std::vector<base::Token>& tokens) {
  base::TokenRow row(line, tokens);
  const auto next = [&] { return row.next_word(kListingBlanks, kListingComment); };
  TokenKind (*kind_of)(std::string_view) = kind_of_head;
  for (std::string_view word = next(); !word.empty(); word = next()) {
    row.put(kind_of(word), word.data() + word.size());
    kind_of = kind_of_value;
  }
  row.put(TokenKind::comment, row.end());
}

}  // namespace

const base::Language& pattern_language() {
  static const base::Language language = {.name = "pattern",
                                          .endings = kEndings,
                                          .comment = {"#"},
                                          .key_words = kKeyWords,
                                          .example = "F T2 4000",
                                          .is_listing = true,
                                          .cut = cut};
  return language;
}

}  // namespace kerf::drive
