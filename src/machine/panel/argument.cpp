#include "machine/panel/argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "base/refusal.hpp"

namespace kerf::machine {

namespace argument {

Argument text(std::string_view name, double most_bytes, std::string_view note, Need need) {
  return {
      .name = name, .kind = Argument::Kind::text, .need = need, .high = most_bytes, .note = note};
}

Argument name_of(std::string_view name, std::string_view note, Need need) {
  return text(name, kMostName, note, need);
}

Argument number(std::string_view name, const Range& range, std::string_view note, Need need) {
  return {.name = name,
          .kind = Argument::Kind::number,
          .need = need,
          .low = range.least,
          .high = range.most,
          .note = note};
}

Argument integer(std::string_view name, const Range& range, std::string_view note, Need need) {
  Argument whole = number(name, range, note, need);
  whole.kind = Argument::Kind::integer;
  return whole;
}

Argument integers(std::string_view name, const Range& range, std::string_view note) {
  Argument list = number(name, range, note);
  list.kind = Argument::Kind::integers;
  return list;
}

Argument flag(std::string_view name, std::string_view note, Need need) {
  return {.name = name, .kind = Argument::Kind::flag, .need = need, .note = note};
}

Argument choice(std::string_view name, std::vector<std::string_view> choices, std::string_view note,
                Need need) {
  return {.name = name,
          .kind = Argument::Kind::choice,
          .need = need,
          .choices = std::move(choices),
          .note = note};
}

Argument nullable(std::string_view name, std::string_view note) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  return {.name = name, .kind = Argument::Kind::nullable, .low = -kAny, .high = kAny, .note = note};
}

Argument texts(std::string_view name, std::string_view note) {
  return {.name = name,
          .kind = Argument::Kind::texts,
          .need = Need::optional,
          .high = kMostName,
          .note = note};
}

}  // namespace argument

namespace {

using base::Failure;
using base::Outcome;
using base::usage;
using Kind = Argument::Kind;

std::string range_text(const Argument& argument) {
  const auto side = [](double value) {
    return std::isfinite(value) ? base::number_text(value) : std::string("any");
  };
  if (!std::isfinite(argument.low) && !std::isfinite(argument.high)) return "";
  return " " + side(argument.low) + " to " + side(argument.high);
}

bool is_range(const Argument& argument) {
  return argument.kind == Kind::number && std::isfinite(argument.low) &&
         std::isfinite(argument.high);
}

std::string list_text(const std::vector<std::string_view>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

bool is_number_in(const Json& value, const Argument& argument) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  return std::isfinite(number) && number >= argument.low && number <= argument.high;
}

bool is_integer_in(const Json& value, const Argument& argument) {
  return is_number_in(value, argument) && value.get<double>() == std::floor(value.get<double>());
}

bool is_text_in(const Json& value, const Argument& argument) {
  return value.is_string() &&
         static_cast<double>(value.get_ref<const std::string&>().size()) <= argument.high;
}

template <typename Fits>
bool every(const Json& value, Fits&& fits) {
  return value.is_array() && value.size() <= kMostEntries &&
         std::all_of(value.begin(), value.end(), fits);
}

bool fits(const Json& value, const Argument& argument) {
  switch (argument.kind) {
    case Kind::flag: return value.is_boolean();
    case Kind::number: return is_number_in(value, argument);
    case Kind::integer: return is_integer_in(value, argument);
    case Kind::nullable: return value.is_null() || is_number_in(value, argument);
    case Kind::text: return is_text_in(value, argument);
    case Kind::choice:
      return value.is_string() &&
             std::find(argument.choices.begin(), argument.choices.end(),
                       value.get_ref<const std::string&>()) != argument.choices.end();
    case Kind::integers:
      return every(value, [&](const Json& each) { return is_integer_in(each, argument); });
    case Kind::texts:
      return every(value, [&](const Json& each) { return is_text_in(each, argument); });
    case Kind::fields: return value.is_object();
    case Kind::list: return every(value, [](const Json& each) { return each.is_object(); });
  }
  return false;
}

Outcome<void> check_fields(const Json& value, const Argument& argument) {
  const auto check = [&](const Json& object) -> Outcome<void> {
    auto checked = check_arguments(object, argument.fields);
    if (checked) return {};
    return usage(std::string(argument.name) + ": " + checked.error().message);
  };
  if (argument.kind == Kind::fields) return check(value);
  if (argument.kind != Kind::list) return {};
  for (const Json& entry : value) {
    if (auto checked = check(entry); !checked) return checked;
  }
  return {};
}

}  // namespace

std::string kind_text(const Argument& argument) {
  switch (argument.kind) {
    case Kind::flag: return "true or false";
    case Kind::number: return "a number" + range_text(argument);
    case Kind::integer: return "a whole number" + range_text(argument);
    case Kind::nullable: return "a number" + range_text(argument) + " or null";
    case Kind::text: return fmt::format("a text of at most {:.0f} bytes", argument.high);
    case Kind::choice: return "one of " + list_text(argument.choices);
    case Kind::integers:
      return fmt::format("a list of at most {} whole numbers{}", kMostEntries,
                         range_text(argument));
    case Kind::texts:
      return fmt::format("a list of at most {} texts of at most {:.0f} bytes", kMostEntries,
                         argument.high);
    case Kind::fields: return "an object";
    case Kind::list: return fmt::format("a list of at most {} objects", kMostEntries);
  }
  return "";
}

Outcome<void> check_arguments(const Json& object, const std::vector<Argument>& arguments,
                              const std::vector<std::string_view>& ignored) {
  for (const auto& [key, value] : object.items()) {
    const bool frame = std::find(ignored.begin(), ignored.end(), key) != ignored.end();
    const auto argument = std::find_if(arguments.begin(), arguments.end(),
                                       [&key = key](const Argument& a) { return a.name == key; });
    if (frame) continue;
    if (argument == arguments.end())
      return usage("there is no argument " + key.substr(0, 40) + " here");
    if (!fits(value, *argument) && is_range(*argument))
      return tl::unexpected(
          base::refuse(base::Refusal::number_range,
                       {std::string(argument->name), base::number_text(argument->low),
                        base::number_text(argument->high)}));
    if (!fits(value, *argument))
      return usage(std::string(argument->name) + " must be " + kind_text(*argument));
    if (auto checked = check_fields(value, *argument); !checked) return checked;
  }
  for (const Argument& argument : arguments) {
    if (argument.need == Argument::Need::required && !object.contains(argument.name))
      return usage("the argument " + std::string(argument.name) +
                   " is missing: " + kind_text(argument));
  }
  return {};
}

std::string Arguments::text(const char* name) const {
  return has(name) ? object_.at(name).get<std::string>() : std::string();
}

double Arguments::number(const char* name) const {
  return has(name) ? object_.at(name).get<double>() : 0;
}

std::int64_t Arguments::integer(const char* name) const {
  return static_cast<std::int64_t>(number(name));
}

bool Arguments::flag(const char* name) const { return has(name) && object_.at(name).get<bool>(); }

double Arguments::nullable(const char* name) const {
  return has(name) && !object_.at(name).is_null() ? object_.at(name).get<double>()
                                                  : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::int64_t> Arguments::integers(const char* name) const {
  std::vector<std::int64_t> all;
  if (!has(name)) return all;
  for (const Json& each : object_.at(name))
    all.push_back(static_cast<std::int64_t>(each.get<double>()));
  return all;
}

std::vector<std::string> Arguments::texts(const char* name) const {
  return has(name) ? object_.at(name).get<std::vector<std::string>>() : std::vector<std::string>();
}

std::vector<Arguments> Arguments::list(const char* name) const {
  std::vector<Arguments> all;
  if (!has(name)) return all;
  for (const Json& each : object_.at(name)) all.emplace_back(each);
  return all;
}

}  // namespace kerf::machine
