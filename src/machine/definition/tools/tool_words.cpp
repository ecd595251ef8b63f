#include "machine/definition/tools/tool_words.hpp"

#include <array>

#include "base/decimal.hpp"
#include "machine/definition/tools/internal/letters.hpp"

namespace kerf::machine {
namespace {

/// How a word may go on.
enum class End : std::uint8_t { any, here };

struct Word {
  std::string_view text;
  std::string_view type;
  End end = End::any;
};

// The more particular ones first: "spot drill" is no drill, a "ball end mill" no end mill.
constexpr std::array<Word, 36> kWords = {{
    {"PROBE", "probe"},
    {"LOLLIPOP", "lollipop"},
    {"DOVETAIL", "dovetail"},
    {"T-SLOT", "t-slot"},
    {"T SLOT", "t-slot"},
    {"SLOT MILL", "t-slot"},
    {"SLITTING", "saw"},
    {"SAW", "saw", End::here},
    {"THREAD MILL", "thread-mill"},
    {"THREADMILL", "thread-mill"},
    {"THREADING", "threading"},
    {"FACE GROOV", "face-grooving"},
    {"GROOV", "grooving"},
    {"PARTING", "parting"},
    {"CUT OFF", "parting"},
    {"BORING BAR", "boring-bar"},
    {"TURNING", "turning"},
    {"BORING", "boring"},
    {"COUNTERSINK", "countersink"},
    {"CHAMFER", "chamfer"},
    {"ENGRAV", "engrave"},
    {"SPOT", "spot"},
    {"CENTER", "spot"},
    {"CENTRE", "spot"},
    {"TAPER", "taper"},
    {"TAP", "tap", End::here},
    {"TAPPING", "tap"},
    {"REAM", "reamer"},
    {"BULL", "bull"},
    {"BALL", "ball"},
    {"SLOT DRILL", "slot"},
    {"DRILL", "drill"},
    {"FACE", "face"},
    {"FLAT", "flat"},
    {"END MILL", "flat"},
    {"ENDMILL", "flat"},
}};

/// Whether a word stands there; one with a "=" behind it is the name of a number.
bool stands_at(const std::string& text, std::size_t at, const Word& word) {
  if (at > 0 && is_capital(text[at - 1])) return false;
  const std::size_t behind = at + word.text.size();
  if (behind == text.size()) return true;
  return text[behind] != '=' && (word.end == End::any || !is_capital(text[behind]));
}

bool has(const std::string& text, const Word& word) {
  for (std::size_t at = text.find(word.text); at != std::string::npos;
       at = text.find(word.text, at + 1)) {
    if (stands_at(text, at, word)) return true;
  }
  return false;
}

// Ø and ø, in UTF-8 and in Latin-1.
std::string with_plain_diameters(std::string text) {
  constexpr std::array<std::string_view, 4> kSigns = {"\xC3\x98", "\xC3\xB8", "\xD8", "\xF8"};
  for (const std::string_view sign : kSigns) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
      text.replace(at, sign.size(), " D");
  }
  return text;
}

std::optional<double> number_at(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() &&
         (is_digit(text[end]) || text[end] == '.' || (end == 0 && text[end] == '-')))
    ++end;
  // 1e9 is not 1.
  const bool has_exponent = end + 1 < text.size() && text[end] == 'E' && is_digit(text[end + 1]);
  if (has_exponent) return {};
  const auto value = base::read_number(text.substr(0, end));
  return value ? std::optional(*value) : std::nullopt;
}

}  // namespace

std::string capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = folded(c);
  return out;
}

stock::NamedKind kind_in_words(std::string_view text) {
  const std::string words = capitals(text);
  for (const Word& word : kWords) {
    if (has(words, word)) return stock::kind_named(word.type);
  }
  return {};
}

std::optional<double> number_behind(std::string_view key, std::string_view text) {
  const std::string words = with_plain_diameters(capitals(text));
  for (std::size_t at = words.find(key); at != std::string::npos; at = words.find(key, at + 1)) {
    if (at > 0 && (is_capital(words[at - 1]) || is_digit(words[at - 1]))) continue;
    std::size_t behind = at + key.size();
    while (behind < words.size() && (words[behind] == ' ' || words[behind] == '=')) ++behind;
    if (const auto value = number_at(std::string_view(words).substr(behind))) return value;
  }
  return {};
}

}  // namespace kerf::machine
