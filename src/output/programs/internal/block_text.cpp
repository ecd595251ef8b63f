#include "output/programs/internal/block_text.hpp"

#include <cctype>
#include <cmath>

#include "base/decimal.hpp"

namespace kerf::output {
namespace {

constexpr double kStep = 1e4;
constexpr std::size_t kLongestComment = 60;
constexpr std::string_view kCommands = "()!~?%;[]#{}";

void append_number(std::string& out, double value) {
  const std::size_t begin = out.size();
  base::append_decimal(out, value);
  if (out.find('.', begin) == std::string::npos) out += '.';
}

}  // namespace

double post_rounded(double value) { return std::round(value * kStep) / kStep + 0.0; }

std::string post_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

geometry::Vec2 post_rounded(geometry::Vec2 point) {
  return {post_rounded(point.u), post_rounded(point.v)};
}

std::string comment_text(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, kLongestComment)) {
    const auto code = static_cast<unsigned char>(c);
    const bool reads = code >= ' ' && code <= '~' && kCommands.find(c) == std::string_view::npos;
    out += reads ? static_cast<char>(std::toupper(code)) : '_';
  }
  return out;
}

BlockText& BlockText::code(std::string_view code) {
  if (!text_.empty()) text_ += ' ';
  text_ += code;
  return *this;
}

BlockText& BlockText::number(char letter, double value) {
  append_number(code({&letter, 1}).text_, value);
  return *this;
}

BlockText& BlockText::count(char letter, double value) {
  base::append_decimal(code({&letter, 1}).text_, value);
  return *this;
}

}  // namespace kerf::output
