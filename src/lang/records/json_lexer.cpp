#include "lang/records/json_lexer.hpp"

#include <algorithm>

#include "base/decimal.hpp"

namespace kerf::records {
namespace {

using PieceKind = JsonPiece::Kind;

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kMarks = "{}[],:";
constexpr std::size_t kHexDigits = 4;

bool is_of(std::string_view set, char c) { return set.find(c) != std::string_view::npos; }

bool is_of_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
         c == '+' || c == '-' || c == '_';
}

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Behind an escape that begins with `\`; null: it is none.
const char* behind_escape(const char* at, const char* end) {
  if (end - at < 2) return nullptr;
  if (at[1] != 'u') return is_of("\"\\/bfnrt", at[1]) ? at + 2 : nullptr;
  const char* const behind = at + 2 + kHexDigits;
  const bool whole = end - at >= 2 + static_cast<std::ptrdiff_t>(kHexDigits) &&
                     std::all_of(at + 2, behind, [](char c) { return hex_value(c) >= 0; });
  return whole ? behind : nullptr;
}

std::uint32_t unit_at(std::string_view digits) {
  std::uint32_t unit = 0;
  for (const char c : digits.substr(0, kHexDigits))
    unit = unit * 16 + static_cast<std::uint32_t>(hex_value(c));
  return unit;
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto low = [](std::uint32_t bits) { return static_cast<char>(0x80U | (bits & 0x3FU)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0U | code >> 6U);
    out += low(code);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0U | code >> 12U);
    out += low(code >> 6U);
    out += low(code);
  } else {
    out += static_cast<char>(0xF0U | code >> 18U);
    out += low(code >> 12U);
    out += low(code >> 6U);
    out += low(code);
  }
}

// Two units of UTF-16 are one character; half of one is U+FFFD. Returns the bytes that were read.
std::size_t append_unicode(std::string& out, std::string_view escape) {
  const std::uint32_t first = unit_at(escape.substr(2));
  const bool pairs = first >= 0xD800 && first < 0xDC00 && escape.size() >= 12 &&
                     escape[6] == '\\' && escape[7] == 'u';
  const std::uint32_t second = pairs ? unit_at(escape.substr(8)) : 0;
  if (second >= 0xDC00 && second < 0xE000) {
    append_utf8(out, 0x10000 + ((first - 0xD800) << 10U) + (second - 0xDC00));
    return 12;
  }
  append_utf8(out, first >= 0xD800 && first < 0xE000 ? 0xFFFD : first);
  return 6;
}

char meant_by(char escape) {
  switch (escape) {
    case 'b': return '\b';
    case 'f': return '\f';
    case 'n': return '\n';
    case 'r': return '\r';
    case 't': return '\t';
    default: return escape;
  }
}

PieceKind kind_of_word(std::string_view text) {
  if (text == "true" || text == "false" || text == "null") return PieceKind::word;
  const bool begins = text[0] == '-' || (text[0] >= '0' && text[0] <= '9');
  return begins && base::read_number(text) ? PieceKind::number : PieceKind::wrong;
}

}  // namespace

JsonPiece JsonLexer::piece(PieceKind kind, const char* behind) {
  const std::string_view text(at_, static_cast<std::size_t>(behind - at_));
  at_ = behind;
  return {kind, text};
}

JsonPiece JsonLexer::string() {
  const char* at = at_ + 1;
  while (at != end_ && *at != '"') {
    if (static_cast<unsigned char>(*at) < ' ') return piece(PieceKind::wrong, at + 1);
    const char* const behind = *at == '\\' ? behind_escape(at, end_) : at + 1;
    if (behind == nullptr) return piece(PieceKind::wrong, at + 1);
    at = behind;
  }
  return at == end_ ? piece(PieceKind::wrong, end_) : piece(PieceKind::string, at + 1);
}

JsonPiece JsonLexer::word() {
  const char* const behind = std::find_if_not(at_, end_, is_of_word);
  if (behind == at_) return piece(PieceKind::wrong, at_ + 1);
  return piece(kind_of_word({at_, static_cast<std::size_t>(behind - at_)}), behind);
}

JsonPiece JsonLexer::next() {
  while (at_ != end_ && is_of(kBlanks, *at_)) ++at_;
  if (at_ == end_) return {PieceKind::end, {at_, 0}};
  if (is_of(kMarks, *at_)) return piece(PieceKind::mark, at_ + 1);
  return *at_ == '"' ? string() : word();
}

std::string json_text(std::string_view string) {
  std::string out;
  string = string.substr(1, string.size() - 2);
  while (!string.empty()) {
    std::size_t read = 1;
    if (string[0] != '\\') {
      out += string[0];
    } else if (string[1] == 'u') {
      read = append_unicode(out, string);
    } else {
      out += meant_by(string[1]);
      read = 2;
    }
    string.remove_prefix(read);
  }
  return out;
}

}  // namespace kerf::records
