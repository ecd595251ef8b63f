#include "base/language.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/text_window.hpp"

namespace kerf::base {
namespace {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

}  // namespace

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

FirstWord FirstWord::of(std::string_view line) {
  FirstWord first;
  line = without_byte_order_mark(line);
  line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
  const auto* const end = std::find_if_not(line.begin(), line.end(), is_of_word);
  first.word = capitals(std::string(line.begin(), end));
  const std::size_t next = line.find_first_not_of(" \t", first.word.size());
  if (next != std::string_view::npos) first.next = line[next];
  return first;
}

std::vector<Token> tokens_of(const Language& language, std::string_view line) {
  std::vector<Token> tokens;
  language.cut(line, tokens);
  return tokens;
}

bool shows_by_ending(const Language& language, const std::string& path) {
  return language.shows_by_ending && capitals(std::filesystem::path(path).extension().string()) ==
                                         capitals(std::string(language.endings.front()));
}

}  // namespace kerf::base
