#include "training/code_lines.hpp"

#include <algorithm>

#include "machine/dialect/registry.hpp"

namespace kerf::training {
namespace {

// Percent signs of a tape and ends of empty blocks say nothing.
bool says_something(base::TokenKind kind, std::string_view text) {
  return kind != base::TokenKind::blank && kind != base::TokenKind::comment &&
         text.find_first_not_of(" \t%;") != std::string_view::npos;
}

bool holds_code(std::string_view line, const base::Language& language) {
  const std::vector<base::Token> tokens = base::tokens_of(language, line);
  return std::any_of(tokens.begin(), tokens.end(), [&](const base::Token& token) {
    return says_something(token.kind, line.substr(token.begin, token.length));
  });
}

}  // namespace

int code_lines(std::string_view program, std::string_view dialect) {
  const base::Language& language = *machine::find_dialect(dialect)->language;
  int count = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find_first_of("\r\n", begin), program.size());
    count += holds_code(program.substr(begin, end - begin), language) ? 1 : 0;
    begin = end + 1;
  }
  return count;
}

}  // namespace kerf::training
