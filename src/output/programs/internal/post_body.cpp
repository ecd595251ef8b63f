#include "output/programs/internal/post_body.hpp"

#include "output/programs/internal/block_text.hpp"

namespace kerf::output {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Whether a word of one digit begins there: G1, G7.1, M3.
bool is_short_code(std::string_view block, std::size_t at) {
  if (block[at] != 'G' && block[at] != 'M') return false;
  const bool begins = at == 0 || block[at - 1] == ' ';
  return begins && at + 1 < block.size() && is_digit(block[at + 1]) &&
         (at + 2 == block.size() || !is_digit(block[at + 2]));
}

}  // namespace

std::string spelled(const PostFlavour& flavour, std::string_view block) {
  if (!flavour.has_two_digits || block.starts_with('(')) return std::string(block);
  std::string text;
  for (std::size_t i = 0; i < block.size(); ++i) {
    text += block[i];
    if (is_short_code(block, i)) text += '0';
  }
  return text;
}

void PostBody::block(std::string_view text) {
  if (text.empty()) return;
  if (flavour_.has_two_digits) {
    file_.write(spelled(flavour_, text));
  } else {
    file_.write(text);
  }
  file_.write("\n");
}

void PostBody::comment(std::uint32_t line, const std::string& text) {
  block("(LINE " + std::to_string(line) + ": " + comment_text(text) + ")");
}

}  // namespace kerf::output
