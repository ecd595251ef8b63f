#include "features/merge/assignments.hpp"

#include <optional>

namespace kerf::features {
namespace {

using base::Token;
using base::TokenKind;

bool is_blank(const Token& token) {
  return token.kind == TokenKind::blank || token.kind == TokenKind::comment;
}

// A line is one `#n=value`, perhaps behind an N word.
std::optional<Assignment> assignment_in(const base::Language& language, const std::string& line,
                                        const std::string& wanted) {
  std::string bare;
  std::size_t from = 0;
  std::size_t to = 0;
  for (const Token& token : base::tokens_of(language, line)) {
    if (is_blank(token)) continue;
    if (bare.empty() && token.kind == TokenKind::sequence) continue;
    const std::string piece = line.substr(token.begin, token.length);
    if (bare == wanted + "=" && from == 0) from = token.begin;
    bare += piece;
    to = token.begin + token.length;
  }
  if (from == 0 || bare.rfind(wanted + "=", 0) != 0) return std::nullopt;
  while (to > from && static_cast<unsigned char>(line[to - 1]) <= ' ') --to;
  return Assignment{from, to - from};
}

bool begins_program(const std::string& line) {
  return !line.empty() && (line[0] == 'O' || line[0] == 'o' || line[0] == ':');
}

}  // namespace

std::vector<Assignment> assignments_of(const base::Language& language, const std::string& text,
                                       std::uint32_t n) {
  std::vector<Assignment> found;
  int programs = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    programs += static_cast<int>(begins_program(line));
    if (programs > 1) break;
    if (auto one = assignment_in(language, line, "#" + std::to_string(n)))
      found.push_back({at + one->from, one->length});
    at = end + 1;
  }
  return found;
}

}  // namespace kerf::features
