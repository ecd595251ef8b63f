#include "machine/dialect/language.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "base/text_window.hpp"

namespace kerf::machine {
namespace {

// So much of a text is looked at.
constexpr std::size_t kLook = 4096;

constexpr std::array kLanguages = {Language{"laser-basic", ".bas", "laser3"},
                                   Language{"teach", ".tch", "laser5"},
                                   Language{"pattern", ".pat", "arm4"}};

// Words that begin a statement of laser BASIC and no block of G-code.
constexpr std::array<std::string_view, 14> kBasicWords = {"LET",  "REM",  "PRINT",  "INPUT", "FOR",
                                                          "NEXT", "HOME", "SPEED",  "POWER", "MOVE",
                                                          "LINE", "ARC",  "CIRCLE", "GOSUB"};

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

// The first word of a line in capitals, and the character behind it.
struct FirstWord {
  std::string word;
  char next = 0;
};

FirstWord first_word(std::string_view line) {
  FirstWord first;
  line = base::without_byte_order_mark(line);
  std::size_t at = line.find_first_not_of(" \t\r");
  if (at == std::string_view::npos) return first;
  const auto in_word = [&] {
    return at < line.size() &&
           (std::isalnum(static_cast<unsigned char>(line[at])) != 0 || line[at] == '_');
  };
  for (; in_word(); ++at) first.word += line[at];
  first.word = upper(first.word);
  at = line.find_first_not_of(" \t", at);
  if (at != std::string_view::npos) first.next = line[at];
  return first;
}

bool looks_like_basic(const FirstWord& first) {
  const bool name = !first.word.empty() && std::isalpha(static_cast<unsigned char>(first.word[0]));
  return name && (first.next == '=' || std::find(kBasicWords.begin(), kBasicWords.end(),
                                                 first.word) != kBasicWords.end());
}

}  // namespace

std::span<const Language> languages() { return kLanguages; }

std::optional<Language> language_by_ending(const std::string& path) {
  const std::string ending = upper(std::filesystem::path(path).extension().string());
  for (const Language& language : kLanguages) {
    if (ending == upper(std::string(language.ending))) return language;
  }
  return std::nullopt;
}

bool ends_as_pattern(const std::string& path) {
  return upper(std::filesystem::path(path).extension().string()) == ".PAT";
}

std::optional<Language> language_by_text(const base::SourceFile& program) {
  std::string text(std::min<std::uint64_t>(kLook, program.size()), '\0');
  text.resize(program.read(0, text));
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const FirstWord first = first_word(std::string_view(text).substr(begin, end - begin));
    if (first.word == "TEACH") return kLanguages[1];
    if (looks_like_basic(first)) return kLanguages[0];
    if (first.next == '%' || first.next == '(' || !first.word.empty()) return std::nullopt;
    begin = end + 1;
  }
  return std::nullopt;
}

std::optional<Language> language_of(std::string_view dialect) {
  for (const Language& language : kLanguages) {
    if (language.dialect == dialect) return language;
  }
  return std::nullopt;
}

}  // namespace kerf::machine
