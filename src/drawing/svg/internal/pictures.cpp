#include "drawing/svg/internal/pictures.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "base/source_file.hpp"
#include "drawing/svg/internal/scanner.hpp"

namespace kerf::drawing::svg {
namespace {

constexpr std::uint64_t kMostBytesOfPicture = 64U << 20U;

tl::unexpected<base::Failure> no_bytes(std::string sentence) {
  return tl::unexpected(base::Failure{base::Failure::Kind::input, std::move(sentence)});
}

std::optional<unsigned> hexadecimal(char c) {
  if (is_digit(c)) return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return std::nullopt;
}

/// "%20" is a blank.
std::string without_percents(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto high =
        text[i] == '%' && i + 2 < text.size() ? hexadecimal(text[i + 1]) : std::nullopt;
    const auto low = high ? hexadecimal(text[i + 2]) : std::nullopt;
    result += low ? static_cast<char>(16 * *high + *low) : text[i];
    if (low) i += 2;
  }
  return result;
}

std::optional<unsigned> six_bits(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<unsigned>(c - 'A');
  if (c >= 'a' && c <= 'z') return static_cast<unsigned>(c - 'a' + 26);
  if (is_digit(c)) return static_cast<unsigned>(c - '0' + 52);
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return std::nullopt;
}

/// Blanks may stand anywhere in it; it ends with the first '='.
std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() * 3 / 4);
  unsigned bits = 0;
  unsigned count = 0;
  for (const char c : text) {
    if (c == '=') break;
    if (is_blank(c)) continue;
    const auto six = six_bits(c);
    if (!six) return std::nullopt;
    bits = bits << 6U | *six;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFFU);
    bits &= (1U << count) - 1;
  }
  return bytes;
}

base::Outcome<std::string> of_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return no_bytes("the data URI has no comma");
  const bool is_base64 = trimmed(uri.substr(0, comma)).ends_with(";base64");
  const std::string data = without_percents(uri.substr(comma + 1));
  if (!is_base64) return data;
  auto bytes = from_base64(data);
  if (!bytes) return no_bytes("the data URI is no base64");
  return *bytes;
}

bool is_plain(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == std::string::npos;
}

/// A file's name in a folder, without any way to it.
std::optional<std::string> plain_name(std::string_view href) {
  if (href.starts_with("./")) href.remove_prefix(2);
  std::string name = without_percents(href);
  return is_plain(name) ? std::optional(std::move(name)) : std::nullopt;
}

}  // namespace

base::Outcome<std::string> bytes_of_href(std::string_view href, const std::string& folder) {
  href = trimmed(href);
  if (same_letters(href.substr(0, 5), "data:")) return of_data_uri(href.substr(5));
  const auto name = plain_name(href);
  const std::string_view shown = href.substr(0, 80);
  if (!name) return no_bytes(fmt::format("'{}' is no file of the drawing's own folder", shown));
  if (folder.empty())
    return no_bytes(fmt::format("'{}' is not read: the drawing came without a folder", shown));
  const std::filesystem::path path = std::filesystem::path(folder) / *name;
  std::error_code error;
  const auto status = std::filesystem::symlink_status(path, error);
  if (std::filesystem::is_symlink(status))
    return no_bytes(fmt::format("'{}' is a link, and none is followed", shown));
  if (!std::filesystem::is_regular_file(status))
    return no_bytes(fmt::format("there is no file '{}' beside the drawing", shown));
  return base::read_whole(path.string(), kMostBytesOfPicture, "a picture");
}

}  // namespace kerf::drawing::svg
