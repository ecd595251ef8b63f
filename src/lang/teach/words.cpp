#include "lang/teach/words.hpp"

#include <algorithm>

namespace kerf::teach {
namespace {

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

Words::Words(std::string_view line) {
  const std::size_t semicolon = line.find(kCommentMark);
  if (semicolon != std::string_view::npos) {
    has_comment_ = true;
    comment_ = line.substr(semicolon + 1);
    line = line.substr(0, semicolon);
  }
  for (std::size_t at = 0;;) {
    at = line.find_first_not_of(kBetweenWords, at);
    if (at == std::string_view::npos) return;
    const std::size_t end = std::min(line.find_first_of(kBetweenWords, at), line.size());
    if (count_ < kMost) words_[count_] = line.substr(at, end - at);
    ++count_;
    at = end;
  }
}

bool same_word(std::string_view word, std::string_view capitals) {
  return std::equal(word.begin(), word.end(), capitals.begin(), capitals.end(),
                    [](char a, char b) { return capital(a) == b; });
}

}  // namespace kerf::teach
