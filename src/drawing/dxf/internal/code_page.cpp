#include "drawing/dxf/internal/code_page.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>

#include "drawing/small_letters.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr char32_t kUnknown = 0xFFFD;

bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// "ansi_1252" and "dos437" are CP1252 and CP437.
std::string charset_of(std::string_view name) {
  const std::string key = in_small_letters(name);
  if (key == "ansi_1361" || key == "johab") return "JOHAB";
  for (const std::string_view prefix : {"ansi_", "dos", "windows-", "cp"})
    if (key.starts_with(prefix)) return "CP" + key.substr(prefix.size());
  if (key.starts_with("iso8859-")) return "ISO-8859-" + key.substr(8);
  if (key == "mac-roman") return "MACINTOSH";
  if (key == "gb2312") return "CP936";
  if (key == "big5") return "CP950";
  if (key == "ksc5601") return "CP949";
  return key;
}

std::size_t length_by(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/// The length of the character at the beginning of `text`; 0: there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = length_by(byte(0));
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  if (length > 2) {  // longer than it needs to be, half of a pair, beyond U+10FFFF
    const unsigned both = (unsigned{byte(0)} << 8U) | byte(1);
    if (both < 0xE0A0 || (both >= 0xEDA0 && both < 0xEE00)) return 0;
    if ((both >= 0xF000 && both < 0xF090) || both >= 0xF490) return 0;
  }
  return length;
}

std::optional<char32_t> hexadecimal(std::string_view digits) {
  char32_t value = 0;
  for (const char c : digits) {
    const char small = static_cast<char>(static_cast<unsigned char>(c) | 0x20U);
    if (c >= '0' && c <= '9')
      value = 16 * value + static_cast<char32_t>(c - '0');
    else if (small >= 'a' && small <= 'f')
      value = 16 * value + static_cast<char32_t>(small - 'a' + 10);
    else
      return std::nullopt;
  }
  return value;
}

bool names_character(std::string_view text) {
  return text.starts_with("\\U+") || text.starts_with("\\u+");
}

/// The number behind "\U+" at the beginning of `text`.
std::optional<char32_t> named_character(std::string_view text) {
  constexpr std::size_t kLength = 7;
  if (text.size() < kLength || !names_character(text)) return std::nullopt;
  return hexadecimal(text.substr(3, 4));
}

std::string with_named_characters(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto first = named_character(text.substr(at));
    if (!first) {
      result += text[at++];
      continue;
    }
    at += 7;
    const auto second = named_character(text.substr(at));
    const bool is_pair = (*first & 0xFC00U) == 0xD800 && second && (*second & 0xFC00U) == 0xDC00;
    if (is_pair) at += 7;
    append_utf8(result,
                is_pair ? 0x10000 + ((*first - 0xD800) << 10U) + (*second - 0xDC00) : *first);
  }
  return result;
}

}  // namespace

void append_utf8(std::string& text, char32_t character) {
  if (character > 0x10FFFF || (character & 0xFFFFF800U) == 0xD800) character = kUnknown;
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const std::uint32_t c = character;
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xC0U | (c >> 6U));
  } else if (c < 0x10000) {
    put(0xE0U | (c >> 12U));
    put(0x80U | ((c >> 6U) & 0x3FU));
  } else {
    put(0xF0U | (c >> 18U));
    put(0x80U | ((c >> 12U) & 0x3FU));
    put(0x80U | ((c >> 6U) & 0x3FU));
  }
  put(0x80U | (c & 0x3FU));
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string sound_utf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0)
      append_utf8(result, kUnknown);
    else
      result += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::string quoted(std::string_view bytes) {
  constexpr std::size_t kMost = 40;
  const bool is_long = bytes.size() > kMost;
  std::string text = sound_utf8(bytes.substr(0, kMost));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return "'" + text + (is_long ? "…'" : "'");
}

bool CodePage::choose(std::string_view name) {
  close();
  is_utf8_ = false;
  const std::string charset = charset_of(name);
  if (charset == "utf-8" || charset == "utf8") {
    is_utf8_ = true;
    return true;
  }
  from_ = iconv_open("UTF-8", charset.c_str());
  return from_ != kNone;
}

void CodePage::choose_utf8() {
  close();
  is_utf8_ = true;
}

void CodePage::close() {
  if (from_ != kNone) iconv_close(from_);
  from_ = kNone;
}

void CodePage::convert(std::string_view raw) {
  text_.clear();
  if (from_ == kNone) {
    text_ = sound_utf8(raw);
    return;
  }
  iconv(from_, nullptr, nullptr, nullptr, nullptr);
  std::string source(raw);
  char* at = source.data();
  std::size_t rest = source.size();
  while (rest > 0) {
    std::array<char, 256> part{};
    char* into = part.data();
    std::size_t room = part.size();
    const bool is_done = iconv(from_, &at, &rest, &into, &room) != static_cast<std::size_t>(-1);
    const bool is_full = !is_done && errno == E2BIG;
    text_.append(part.data(), into);
    if (is_done || is_full) continue;
    append_utf8(text_, kUnknown);  // a byte that is no character, or half of one at the end
    ++at;
    --rest;
  }
}

std::string_view CodePage::operator()(std::string_view raw) {
  const bool has_names = raw.find("\\U+") != raw.npos || raw.find("\\u+") != raw.npos;
  if (is_plain(raw) && !has_names) return raw;
  // Files that name no code page are UTF-8 by some programs, and of Windows by others: the first
  // where they can be, which hardly ever happens to the second.
  if (is_utf8_ || (from_ == kNone && is_utf8(raw))) {
    text_ = sound_utf8(raw);
  } else {
    if (from_ == kNone) from_ = iconv_open("UTF-8", "CP1252");
    convert(raw);
  }
  // In two bytes of a code page one may look like a backslash: names are looked for behind it.
  if (has_names) text_ = with_named_characters(text_);
  return text_;
}

}  // namespace kerf::drawing::dxf
