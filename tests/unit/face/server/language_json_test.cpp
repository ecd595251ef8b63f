// Languages as a page is told of them.
#include "face/server/protocol/language_json.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lang/basic/language.hpp"
#include "lang/gcode/language.hpp"

namespace kerf::server {
namespace {

// "3 command 2 dimension": lengths and kinds of the tokens of one line.
std::string told(const base::Language& language, const std::string& line) {
  const Json kinds = token_kinds_json();
  std::string text;
  const Json tokens = tokens_json(language, line).at(0);
  for (std::size_t i = 0; i < tokens.size(); i += 2) {
    text += text.empty() ? "" : " ";
    text += std::to_string(tokens[i + 1].get<int>()) + " " +
            kinds.at(tokens[i].get<std::size_t>()).get<std::string>();
  }
  return text;
}

TEST(LanguageJson, LengthsAreInUnitsOfUtf16) {
  EXPECT_EQ(told(gcode::language(), "(\xC3\xA9\xE7\xA8\x8B\xF0\x9F\x98\x80)X1"),
            "6 comment 2 dimension");
  // Full-width letters are words of laser BASIC.
  EXPECT_EQ(told(basic::language(), "\xEF\xBC\xA5\xEF\xBC\xAE\xEF\xBC\xA4"), "3 keyword");
  EXPECT_EQ(told(gcode::language(), "\xC2\xB0"), "1 error");
}

TEST(LanguageJson, EveryLineHasItsList) {
  EXPECT_EQ(tokens_json(gcode::language(), "").size(), 1U);
  EXPECT_EQ(tokens_json(gcode::language(), "X1\n\nX2\n").size(), 4U);
}

TEST(LanguageJson, EveryKindHasAName) {
  std::set<std::string> names;
  for (const Json& name : token_kinds_json()) names.insert(name.get<std::string>());
  EXPECT_EQ(names.size(), static_cast<std::size_t>(base::TokenKind::error) + 1);
  EXPECT_FALSE(names.contains(""));
}

}  // namespace
}  // namespace kerf::server
