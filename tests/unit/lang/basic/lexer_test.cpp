#include "lang/basic/lexer.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace kerf::basic {
namespace {

std::vector<Token> tokens_of(const std::string& line) {
  std::vector<Token> tokens;
  for (Lexer lexer(line);;) {
    Token token = lexer.next();
    if (token.type == TokenType::finished) return tokens;
    tokens.push_back(std::move(token));
  }
}

// A letter for each token: Variable, Number, Command, Quote, Wrong, Delimiter.
std::string kinds(const std::string& line) {
  std::string text;
  for (const Token& token : tokens_of(line)) {
    switch (token.type) {
      case TokenType::variable: text += 'V'; break;
      case TokenType::number: text += 'N'; break;
      case TokenType::command: text += 'C'; break;
      case TokenType::quote: text += 'Q'; break;
      case TokenType::wrong: text += 'W'; break;
      case TokenType::delimiter: text += 'D'; break;
      case TokenType::string:
      case TokenType::finished: text += '?'; break;
    }
  }
  return text;
}

double number(const std::string& line) {
  const auto tokens = tokens_of(line);
  EXPECT_EQ(tokens.size(), 1U) << line;
  EXPECT_EQ(tokens.at(0).type, TokenType::number) << line;
  return tokens.at(0).number;
}

TEST(BasicLexer, CutsTheExampleOfTheManualIntoNineTokens) {
  const std::string line = "A=B-(C+15)";
  const auto tokens = tokens_of(line);
  EXPECT_EQ(kinds(line), "VDVDDVDND");
  ASSERT_EQ(tokens.size(), 9U);
  const char* const texts[] = {"A", "=", "B", "-", "(", "C", "+", "15", ")"};
  for (std::size_t i = 0; i < tokens.size(); ++i)
    EXPECT_EQ(std::string(tokens[i].begin, tokens[i].end), texts[i]);
  EXPECT_EQ(tokens[7].number, 15);
}

TEST(BasicLexer, TakesTheLongestSign) {
  using D = Delimiter;
  const std::vector<D> wanted = {D::equal,         D::assign,     D::less_equal, D::not_equal,
                                 D::greater_equal, D::not_equal,  D::less,       D::less,
                                 D::greater,       D::less_equal, D::assign};
  const auto tokens = tokens_of("=== <= <> >= != << ><==");
  ASSERT_EQ(tokens.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(tokens[i].delimiter, wanted[i]) << i;
}

TEST(BasicLexer, KnowsEverySign) {
  EXPECT_EQ(kinds("+-*/%^()=,;:"), std::string(12, 'D'));
  EXPECT_EQ(kinds("#$&!?@[]\\`{|}~"), std::string(14, 'W'));
}

TEST(BasicLexer, ReadsNumbersOfAllForms) {
  EXPECT_EQ(number("15"), 15);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("007.250"), 7.25);
  EXPECT_EQ(number("1e3"), 1000);
  EXPECT_EQ(number("2.5E-1"), 0.25);
  EXPECT_EQ(number("1e+2"), 100);
}

TEST(BasicLexer, WhatIsGluedToANumberBelongsToTheMistake) {
  for (const std::string line :
       {"3abc", "1.2.3", "1e", "1e+", "1_", "1..2", "1e5e", "1e999", "3.", "3.e2"}) {
    const auto tokens = tokens_of(line);
    ASSERT_FALSE(tokens.empty()) << line;
    EXPECT_EQ(tokens[0].type, TokenType::wrong) << line;
    EXPECT_EQ(tokens[0].mistake, base::Code::basic_number) << line;
  }
  EXPECT_EQ(tokens_of("3abc+1").size(), 3U);
}

TEST(BasicLexer, WordsAreTheSameInCapitals) {
  for (const std::string line : {"print", "PRINT", "PrInT"})
    EXPECT_EQ(tokens_of(line).at(0).word, Word::print);
  EXPECT_EQ(tokens_of("aB_9").at(0).text, "AB_9");
  EXPECT_EQ(kinds("prints fort to_ _"), "VVVV");
  EXPECT_EQ(kinds("for3to"), "V") << "only what ends a word parts two";
}

TEST(BasicLexer, ACommentEndsTheLine) {
  EXPECT_EQ(kinds("x ' y $ \""), "V");
  EXPECT_EQ(kinds("x rem y $ \""), "V");
  EXPECT_EQ(kinds("REM"), "");
  EXPECT_EQ(kinds("remark"), "V");
}

TEST(BasicLexer, AQuoteKeepsWhatIsInIt) {
  EXPECT_EQ(tokens_of("\"a ' REM  b\"").at(0).text, "a ' REM  b");
  EXPECT_EQ(tokens_of("\"\"").at(0).text, "");
  EXPECT_EQ(tokens_of("\"\xEF\xBC\xA1\"").at(0).text, "\xEF\xBC\xA1");
  EXPECT_EQ(tokens_of("\"open").at(0).mistake, base::Code::basic_quote);
}

TEST(BasicLexer, FullWidthCountsAsAscii) {
  const auto tokens = tokens_of("\xEF\xBD\x81\xEF\xBC\x9D\xEF\xBC\x97\xE3\x80\x80\xEF\xBC\x8B 1");
  ASSERT_EQ(tokens.size(), 5U);
  EXPECT_EQ(tokens[0].text, "A");
  EXPECT_EQ(tokens[1].delimiter, Delimiter::assign);
  EXPECT_EQ(tokens[2].number, 7);
  EXPECT_EQ(tokens[3].delimiter, Delimiter::plus);
}

TEST(BasicLexer, AForeignCharacterIsOneMistakeWhateverItsBytes) {
  for (const std::string line :
       {"\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "\xFF", "\xE2", "\x01"})
    EXPECT_EQ(kinds(line), "W");
  EXPECT_EQ(kinds("\xEF=1"), "WDN") << "what follows a broken character is read";
  EXPECT_EQ(kinds(std::string(1, '\0')), "W");
}

}  // namespace
}  // namespace kerf::basic
