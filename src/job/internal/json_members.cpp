#include "job/internal/json_members.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::job {
namespace {

using JsonKind = PlacedJson::Kind;

constexpr double kFarthest = 1e6;  // mm, degrees, mm/min

bool is_in_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::size_t length = std::min(word.size(), kLongest);
  while (length < word.size() && is_in_character(word[length])) --length;
  std::string shown = "`" + std::string(word.substr(0, length));
  for (char& byte : shown) {
    if (static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F) byte = '?';
  }
  return shown + (length < word.size() ? "…`" : "`");
}

double number_at(const PlacedJson& json, std::size_t value, const std::string& what) {
  if (json[value].kind != JsonKind::number) throw Misread{what + " IS NO NUMBER", value};
  const double number = json[value].number;
  if (!(std::fabs(number) <= kFarthest)) throw Misread{what + " IS BEYOND 1000000", value};
  return number;
}

std::vector<std::size_t> elements_at(const PlacedJson& json, std::size_t value,
                                     const std::string& what) {
  if (json[value].kind != JsonKind::array) throw Misread{what + " IS NO LIST", value};
  std::vector<std::size_t> elements;
  for (std::size_t i = value + 1; i < json[value].end; i = json[i].end) elements.push_back(i);
  return elements;
}

JsonMembers::JsonMembers(const PlacedJson& json, std::size_t object)
    : json_(json), object_(object) {
  if (json[object].kind != JsonKind::object) throw Misread{"THIS IS NO OBJECT", object};
  for (std::size_t i = object + 1; i < json[object].end; i = json[i + 1].end) {
    members_.push_back({i, false});
  }
}

bool JsonMembers::has(std::string_view name) const {
  return std::any_of(members_.begin(), members_.end(),
                     [&](const Member& member) { return json_.text(member.name) == name; });
}

std::optional<std::size_t> JsonMembers::find(std::string_view name) {
  for (Member& member : members_) {
    if (json_.text(member.name) != name) continue;
    member.is_known = true;
    return member.name + 1;
  }
  return std::nullopt;
}

std::size_t JsonMembers::need(std::string_view name) {
  if (const auto value = find(name)) return *value;
  refuse(in_quotes(name) + " IS MISSING");
}

double JsonMembers::number(std::string_view name) {
  return number_at(json_, need(name), in_quotes(name));
}

std::optional<double> JsonMembers::number_if(std::string_view name) {
  return has(name) ? std::optional{number(name)} : std::nullopt;
}

double JsonMembers::positive(std::string_view name) {
  const double value = number(name);
  if (!(value > 0)) throw Misread{in_quotes(name) + " IS NOT ABOVE 0", need(name)};
  return value;
}

std::optional<double> JsonMembers::positive_if(std::string_view name) {
  return has(name) ? std::optional{positive(name)} : std::nullopt;
}

std::size_t JsonMembers::count(std::string_view name, std::size_t least) {
  const double value = number(name);
  if (value != std::floor(value) || value < static_cast<double>(least)) {
    throw Misread{in_quotes(name) + " IS NO WHOLE NUMBER FROM " + std::to_string(least),
                  need(name)};
  }
  return static_cast<std::size_t>(value);
}

std::optional<std::size_t> JsonMembers::count_if(std::string_view name, std::size_t least) {
  return has(name) ? std::optional{count(name, least)} : std::nullopt;
}

std::string JsonMembers::word(std::string_view name) {
  const std::size_t value = need(name);
  if (json_[value].kind != JsonKind::string) throw Misread{in_quotes(name) + " IS NO TEXT", value};
  if (json_.text(value).empty()) throw Misread{in_quotes(name) + " IS EMPTY", value};
  return json_.text(value);
}

std::optional<std::string> JsonMembers::word_if(std::string_view name) {
  return has(name) ? std::optional{word(name)} : std::nullopt;
}

bool JsonMembers::flag_if(std::string_view name) {
  const auto value = find(name);
  if (!value) return false;
  if (json_[*value].kind != JsonKind::boolean) {
    throw Misread{in_quotes(name) + " IS NEITHER true NOR false", *value};
  }
  return json_[*value].truth;
}

void JsonMembers::expect_all_known(const std::string& where) const {
  for (const Member& member : members_) {
    if (member.is_known) continue;
    throw Misread{where + " HAS NO MEMBER " + in_quotes(json_.text(member.name)), member.name};
  }
}

void JsonMembers::refuse(std::string sentence) const {
  throw Misread{std::move(sentence), object_};
}

}  // namespace kerf::job
