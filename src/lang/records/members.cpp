#include "lang/records/members.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/decimal.hpp"

namespace kerf::records {
namespace {

constexpr std::size_t kMostMembers = 64;

}  // namespace

// A name twice leaves open which of them counts.
Members::Members(const JsonLine& line, std::size_t object) : line_(line), object_(object) {
  std::array<std::string_view, kMostMembers> names;
  std::size_t count = 0;
  each([&](const JsonValue& member) {
    if (count == names.size()) return wrong(line_.values()[object_], "has more than 64 members");
    if (std::find(names.begin(), names.begin() + count, member.name) != names.begin() + count)
      wrong(member, "stands there twice");
    names[count++] = member.name;
  });
}

void Members::refuse(Mistake mistake) {
  if (!mistake_) mistake_ = std::move(mistake);
}

void Members::wrong(const JsonValue& value, const std::string& what) {
  const std::string who = value.name.empty() ? "the value " : std::string(value.name) + " ";
  refuse({base::Code::motion_member, who + what, value.text});
}

const JsonValue* Members::find(std::string_view name, Need need) {
  if (mistake_) return nullptr;
  std::size_t number = 0;
  for (std::size_t i = object_ + 1; i < end(); i = line_.values()[i].end, ++number) {
    if (line_.values()[i].name != name) continue;
    asked_ |= std::uint64_t{1} << number;
    return &line_.values()[i];
  }
  if (need == Need::needed)
    refuse({base::Code::motion_member, std::string(name) + " is missing",
            line_.values()[object_].text});
  return nullptr;
}

bool Members::is(const JsonValue& value, JsonValue::Kind kind, const char* what) {
  if (value.kind != kind) wrong(value, std::string("is not ") + what);
  return value.kind == kind;
}

double Members::number_of(const JsonValue& value) {
  return is(value, JsonValue::Kind::number, "a number") ? value.number : 0;
}

double Members::within(const JsonValue& value, double least, double most) {
  const double number = number_of(value);
  if (value.kind == JsonValue::Kind::number && !(number >= least && number <= most))
    wrong(value, "is " + base::number_text(number) + ": it can be from " +
                     base::number_text(least) + " to " + base::number_text(most));
  return number;
}

double Members::number(std::string_view name, double least, double most) {
  const JsonValue* const value = find(name);
  return value == nullptr ? 0 : within(*value, least, most);
}

std::optional<double> Members::number_if(std::string_view name, double least, double most) {
  const JsonValue* const value = find(name, Need::optional);
  if (value == nullptr) return std::nullopt;
  return within(*value, least, most);
}

std::uint32_t Members::whole(std::string_view name, double most, Need need) {
  const JsonValue* const value = find(name, need);
  if (value == nullptr) return 0;
  const double number = within(*value, 0, most);
  if (mistake_) return 0;
  if (number != std::floor(number)) wrong(*value, "is no whole number");
  return static_cast<std::uint32_t>(number);
}

bool Members::truth(std::string_view name, Need need) {
  const JsonValue* const value = find(name, need);
  if (value == nullptr) return false;
  if (value->text != "true" && value->text != "false") wrong(*value, "is neither true nor false");
  return value->text == "true";
}

std::string_view Members::string(std::string_view name, Need need) {
  const JsonValue* const value = find(name, need);
  if (value == nullptr || !is(*value, JsonValue::Kind::string, "a text")) return {};
  return value->text;
}

std::size_t Members::one_of(std::string_view name, std::initializer_list<std::string_view> words) {
  const JsonValue* const value = find(name);
  if (value == nullptr) return 0;
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  if (value->kind == JsonValue::Kind::string) {
    const auto* const found =
        std::find(words.begin(), words.end(), value->text.substr(1, value->text.size() - 2));
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  }
  wrong(*value, "is not one of " + list);
  return 0;
}

std::optional<std::size_t> Members::object(std::string_view name, Need need) {
  const JsonValue* const value = find(name, need);
  if (value == nullptr || !is(*value, JsonValue::Kind::object, "an object")) return std::nullopt;
  return index_of(*value);
}

std::string_view Members::rest() const {
  std::string_view first;
  std::size_t number = 0;
  each([&](const JsonValue& member) {
    if ((asked_ >> number++ & 1U) == 0 && first.empty()) first = member.name;
  });
  return first;
}

}  // namespace kerf::records
