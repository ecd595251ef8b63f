#pragma once

#include <string>

#include "base/language.hpp"
#include "base/token.hpp"

namespace kerf::test {

/// "N10|sequence G90|command"; blanks are left out.
inline std::string tokens_of_line(const base::Language& language, const std::string& line) {
  std::string text;
  for (const base::Token& token : base::tokens_of(language, line)) {
    if (token.kind == base::TokenKind::blank) continue;
    if (!text.empty()) text += ' ';
    text += line.substr(token.begin, token.length) + "|";
    text += base::name_of(token.kind);
  }
  return text;
}

}  // namespace kerf::test
