#include "face/server/store/program_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "base/refusal.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {
namespace {

constexpr std::size_t kLongestProgram = 100;
constexpr std::size_t kLongestMachine = 32;
constexpr std::string_view kForbidden = "/\\:*?\"<>|";

using base::Refusal;

tl::unexpected<base::Failure> wrong(Refusal refusal, std::vector<std::string> values = {}) {
  return tl::unexpected(base::refuse(refusal, std::move(values)));
}

using Range = std::pair<char32_t, char32_t>;

bool is_in(const std::vector<char32_t>& text, std::initializer_list<Range> ranges) {
  return std::any_of(text.begin(), text.end(), [&](char32_t c) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [c](const Range& range) { return range.first <= c && c <= range.second; });
  });
}

// Of well formed UTF-8.
std::vector<char32_t> characters_of(const std::string& text) {
  std::vector<char32_t> characters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) {
      characters.back() = (characters.back() << 6U) | (byte & 0x3FU);
    } else {
      const unsigned lead = byte < 0x80U   ? 0x7FU
                            : byte < 0xE0U ? 0x1FU
                            : byte < 0xF0U ? 0x0FU
                                           : 0x07U;
      characters.push_back(byte & lead);
    }
  }
  return characters;
}

// Controls of direction and of joining: two names that look the same would not be.
bool has_unseen(const std::vector<char32_t>& text) {
  return is_in(text, {{0x80, 0x9F},
                      {0xAD, 0xAD},
                      {0x61C, 0x61C},
                      {0x180E, 0x180E},
                      {0x200B, 0x200F},
                      {0x2028, 0x202E},
                      {0x2060, 0x206F},
                      {0xFEFF, 0xFEFF},
                      {0xFFF9, 0xFFFB},
                      {0xE0000, 0xE0FFF}});
}

// Accents, voice marks of kana and letters of Hangul that stand beside what they belong to: the
// decomposed form (NFD) of a name that looks the same composed (NFC).
bool is_decomposed(const std::vector<char32_t>& text) {
  return is_in(text, {{0x300, 0x36F}, {0x3099, 0x309A}, {0x1100, 0x11FF}});
}

// Names that no Windows computer can have as those of files, whatever their ending.
bool is_reserved(const std::string& name) {
  std::string stem = name.substr(0, name.find('.'));
  while (stem.ends_with(' ')) stem.pop_back();
  for (char& c : stem) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  constexpr std::array<std::string_view, 4> kDevices = {"CON", "PRN", "AUX", "NUL"};
  if (std::find(kDevices.begin(), kDevices.end(), stem) != kDevices.end()) return true;
  const bool port = stem.starts_with("COM") || stem.starts_with("LPT");
  return port && stem.size() == 4 && stem[3] >= '1' && stem[3] <= '9';
}

bool at_an_end(const std::string& name, char c) { return name.front() == c || name.back() == c; }

}  // namespace

base::Outcome<void> check_program_name(const std::string& name) {
  if (name.empty()) return wrong(Refusal::program_name_missing);
  if (name.size() > kLongestProgram)
    return wrong(Refusal::program_name_long, {std::to_string(name.size())});
  const std::string shown = output::printable(name);
  if (shown != name) return wrong(Refusal::program_name_text, {shown});
  const std::size_t bad = name.find_first_of(kForbidden);
  if (bad != std::string::npos)
    return wrong(Refusal::program_name_character, {shown, std::string(1, name[bad])});
  const std::vector<char32_t> characters = characters_of(name);
  if (has_unseen(characters)) return wrong(Refusal::program_name_unseen);
  if (is_decomposed(characters)) return wrong(Refusal::program_name_accent, {shown});
  if (is_reserved(name)) return wrong(Refusal::program_name_device, {shown});
  if (name.front() == '-') return wrong(Refusal::program_name_dash, {shown});
  if (at_an_end(name, '.') || at_an_end(name, ' '))
    return wrong(Refusal::program_name_ends, {shown});
  return {};
}

base::Outcome<void> check_machine_name(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (name.empty() || name.size() > kLongestMachine || !std::all_of(name.begin(), name.end(), fits))
    return wrong(Refusal::machine_name);
  return {};
}

}  // namespace kerf::server
