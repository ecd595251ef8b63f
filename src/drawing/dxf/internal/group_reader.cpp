#include "drawing/dxf/internal/group_reader.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "drawing/dxf/internal/code_page.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr int kLargestCode = 1071;
constexpr int kNoCode = -1;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\0'; }

std::string_view without_blanks_behind(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

int code_in(std::string_view line) {
  const std::string_view text = without_blanks(line);
  if (text.empty() || text.size() > 4) return kNoCode;
  int code = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return kNoCode;
    code = 10 * code + (c - '0');
  }
  return code <= kLargestCode ? code : kNoCode;
}

bool is_word(std::string_view text) {
  const char first = text.empty() ? '0' : text.front();
  return (first >= 'A' && first <= 'Z') || (first >= '3' && text.starts_with("3D"));
}

}  // namespace

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return without_blanks_behind(text);
}

GroupReader::GroupReader(const base::SourceFile& file, base::FileId id) {
  window_.stand_at(file, id, 0, file.size());
}

bool GroupReader::next_line(std::string_view& text) {
  base::TextWindow::Line line;
  if (!window_.next(line)) return false;
  ++line_;
  text = line_ == 1 ? base::without_byte_order_mark(line.text) : line.text;
  is_too_long_ = line.too_long;
  return true;
}

GroupReader::Outcome GroupReader::value_of(int code, RawGroup& group) {
  std::string_view text;
  if (!next_line(text)) return Outcome::end;
  if (is_too_long_) {
    fault_ = fmt::format("the line of group {} is longer than any", code);
    return Outcome::broken;
  }
  group = {code, line_, without_blanks_behind(text)};
  return Outcome::group;
}

GroupReader::Outcome GroupReader::next(RawGroup& group) {
  std::string_view text;
  if (!next_line(text)) return Outcome::end;
  const int code = code_in(text);
  if (code != kNoCode) return value_of(code, group);
  const bool is_last = without_blanks(text).empty() && !window_.more();
  if (is_last && !is_too_long_) return Outcome::end;  // an empty line at the end
  fault_ = fmt::format("{} is no group code", quoted(text));
  return Outcome::broken;
}

GroupReader::Outcome GroupReader::find_next_word(RawGroup& group) {
  std::string_view text;
  bool is_zero = false;
  while (next_line(text)) {
    const std::string_view word = without_blanks(text);
    if (is_zero && is_word(word)) {
      group = {0, line_, word};
      return Outcome::group;
    }
    is_zero = word == "0";
  }
  return Outcome::end;
}

}  // namespace kerf::drawing::dxf
