#include "lang/gcode/keywords.hpp"

#include <array>

#include "lang/gcode/lexer.hpp"

namespace kerf::gcode {
namespace {

struct Spelling {
  std::string_view text;
  Keyword keyword;
};

// Longer spellings stand before their abbreviations.
constexpr Spelling kStatements[] = {
    {"GOTO", Keyword::go_to},   {"IF", Keyword::if_},      {"THEN", Keyword::then},
    {"WHILE", Keyword::while_}, {"DO", Keyword::do_},      {"END", Keyword::end},
    {"POPEN", Keyword::popen},  {"PCLOS", Keyword::pclos}, {"BPRNT", Keyword::bprnt},
    {"DPRNT", Keyword::dprnt},  {"SETVN", Keyword::setvn}, {"GO", Keyword::go_to},
    {"TH", Keyword::then},      {"WH", Keyword::while_},   {"EN", Keyword::end},
    {"PO", Keyword::popen},     {"PC", Keyword::pclos},    {"BP", Keyword::bprnt},
    {"DP", Keyword::dprnt},     {"SE", Keyword::setvn}};

constexpr Spelling kOperators[] = {
    {"AND", Keyword::and_}, {"OR", Keyword::or_}, {"XOR", Keyword::xor_}, {"MOD", Keyword::mod},
    {"EQ", Keyword::eq},    {"NE", Keyword::ne},  {"GT", Keyword::gt},    {"GE", Keyword::ge},
    {"LT", Keyword::lt},    {"LE", Keyword::le},  {"AN", Keyword::and_},  {"XO", Keyword::xor_},
    {"MO", Keyword::mod}};

constexpr Spelling kFunctions[] = {
    {"SIN", Keyword::sin},   {"COS", Keyword::cos},   {"TAN", Keyword::tan},
    {"ASIN", Keyword::asin}, {"ACOS", Keyword::acos}, {"ATAN", Keyword::atan},
    {"SQRT", Keyword::sqrt}, {"SQR", Keyword::sqrt},  {"ABS", Keyword::abs},
    {"BIN", Keyword::bin},   {"BCD", Keyword::bcd},   {"ROUND", Keyword::round},
    {"RND", Keyword::round}, {"FIX", Keyword::fix},   {"FUP", Keyword::fup},
    {"LN", Keyword::ln},     {"EXP", Keyword::exp},   {"POW", Keyword::pow},
    {"ADP", Keyword::adp},   {"PRM", Keyword::prm},   {"SI", Keyword::sin},
    {"CO", Keyword::cos},    {"TA", Keyword::tan},    {"AS", Keyword::asin},
    {"AC", Keyword::acos},   {"AT", Keyword::atan},   {"SQ", Keyword::sqrt},
    {"AB", Keyword::abs},    {"BI", Keyword::bin},    {"BC", Keyword::bcd},
    {"RO", Keyword::round},  {"FI", Keyword::fix},    {"FU", Keyword::fup},
    {"EX", Keyword::exp},    {"PO", Keyword::pow},    {"AD", Keyword::adp},
    {"PR", Keyword::prm}};

// The first spelling of each is the longest one.
constexpr auto kWhole = [] {
  std::array<std::string_view, static_cast<std::size_t>(Keyword::prm)> whole{};
  const auto take = [&](std::span<const Spelling> spellings) {
    for (const Spelling& spelling : spellings) {
      std::string_view& text = whole[static_cast<std::size_t>(spelling.keyword) - 1];
      if (text.empty()) text = spelling.text;
    }
  };
  take(kStatements);
  take(kOperators);
  take(kFunctions);
  return whole;
}();

bool starts_with(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (Cursor::fold(text[i]) != word[i]) return false;
  }
  return true;
}

KeywordMatch find(std::string_view text, std::span<const Spelling> spellings) {
  for (const Spelling& spelling : spellings) {
    if (starts_with(text, spelling.text)) return {spelling.keyword, spelling.text.size()};
  }
  return {};
}

}  // namespace

KeywordMatch statement_at(std::string_view text) { return find(text, kStatements); }
KeywordMatch operator_at(std::string_view text) { return find(text, kOperators); }
KeywordMatch function_at(std::string_view text) { return find(text, kFunctions); }

std::span<const std::string_view> key_words() { return kWhole; }

}  // namespace kerf::gcode
