#include "drawing/dxf/internal/words.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "drawing/dxf/internal/code_page.hpp"
#include "drawing/small_letters.hpp"

namespace kerf::drawing::dxf {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Appends what "%%" and the text behind it stand for; returns how many bytes that are, 0: nothing.
std::size_t take_percent(std::string_view text, std::string& words) {
  if (text.size() < 3 || !text.starts_with("%%")) return 0;
  const char code = small_letter(text[2]);
  if (is_digit(code)) {
    std::size_t end = 3;
    while (end < std::min<std::size_t>(text.size(), 5) && is_digit(text[end])) ++end;
    const auto number = base::read_whole_number(text.substr(2, end - 2));
    if (!number || *number == 0) return 0;
    append_utf8(words, static_cast<char32_t>(*number));
    return end;
  }
  switch (code) {
    case 'c': words += "\u00D8"; return 3;
    case 'd': words += "\u00B0"; return 3;
    case 'p': words += "\u00B1"; return 3;
    case '%': words += '%'; return 3;
    case 'u':
    case 'o':
    case 'k': return 3;
    default: return 0;
  }
}

/// Goes through an MTEXT.
class Formats {
 public:
  explicit Formats(std::string_view text) : text_(text) {}

  std::string words() {
    while (at_ < text_.size()) step();
    return std::move(words_);
  }

 private:
  void step();
  void take_backslash();
  void take_caret();
  void take_stack();
  std::string_view up_to_semicolon();

  std::string_view text_;
  std::size_t at_ = 0;
  std::string words_;
};

void Formats::step() {
  const std::size_t taken = take_percent(text_.substr(at_), words_);
  at_ += taken;
  if (taken > 0) return;
  switch (text_[at_]) {
    case '\\': return take_backslash();
    case '^': return take_caret();
    case '{':  // the limits of a format
    case '}': ++at_; return;
    default: words_ += text_[at_++];
  }
}

/// What stands up to the next semicolon, behind which it goes on; up to the end where there is
/// none.
std::string_view Formats::up_to_semicolon() {
  const std::size_t end = std::min(text_.find(';', at_), text_.size());
  const std::string_view part = text_.substr(at_, end - at_);
  at_ = std::min(end + 1, text_.size());
  return part;
}

void Formats::take_backslash() {
  const char code = at_ + 1 < text_.size() ? text_[at_ + 1] : '\\';
  at_ = std::min(at_ + 2, text_.size());
  switch (code) {
    case 'P':  // paragraph, line and column
    case 'X':
    case 'N': words_ += '\n'; return;
    case '~': words_ += "\u00A0"; return;
    case 'L':
    case 'l':
    case 'O':
    case 'o':
    case 'K':
    case 'k': return;
    case 'S': return take_stack();
    case 'A':
    case 'C':
    case 'c':
    case 'F':
    case 'f':
    case 'H':
    case 'Q':
    case 'T':
    case 'W':
    case 'p': up_to_semicolon(); return;
    default: words_ += code;
  }
}

// "1^ 2", "1/2" and "1#2" are one above the other.
void Formats::take_stack() {
  for (const char c : up_to_semicolon()) {
    if (c == '^' || c == '#' || c == '/')
      words_ += '/';
    else if (c != ' ' && c != '\\')
      words_ += c;
  }
}

void Formats::take_caret() {
  const char code = at_ + 1 < text_.size() ? text_[at_ + 1] : ' ';
  at_ = std::min(at_ + 2, text_.size());
  if (code == 'I')
    words_ += ' ';
  else if (code == 'J')
    words_ += '\n';
  else if (code == ' ')
    words_ += '^';
  else if (code != 'M')
    words_ += {'^', code};
}

}  // namespace

std::string words_of_text(std::string_view coded) {
  std::string words;
  while (!coded.empty()) {
    const std::size_t taken = take_percent(coded, words);
    if (taken == 0) words += coded.front();
    coded.remove_prefix(std::max<std::size_t>(taken, 1));
  }
  return words;
}

std::string words_of_mtext(std::string_view coded) { return Formats(coded).words(); }

}  // namespace kerf::drawing::dxf
