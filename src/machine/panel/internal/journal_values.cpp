#include "machine/panel/internal/journal_values.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "lang/vm/value.hpp"
#include "machine/definition/state_file.hpp"

namespace kerf::machine {
namespace {

constexpr std::uint64_t kFirstVolatile = 100;
constexpr double kFarthest = 1e7;  // mm and degrees: no machine stands there

bool is_utf8(const std::string& text) {
  try {
    static_cast<void>(Json(text).dump());
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

// Each byte as a character of its own.
std::string widened(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xc0U | (byte >> 6U));
      text += static_cast<char>(0x80U | (byte & 0x3fU));
    }
  }
  return text;
}

std::string narrowed(const std::string& text, const char* where) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    if (first >= 0x80 && (first > 0xc3 || ++i == text.size()))
      throw NoJournal{std::string(where) + " holds characters that are no bytes"};
    bytes += first < 0x80 ? text[i]
                          : static_cast<char>((first & 0x03U) << 6U |
                                              (static_cast<unsigned char>(text[i]) & 0x3fU));
  }
  return bytes;
}

std::string string_of(const Json& value, const char* where) {
  if (!value.is_string()) throw NoJournal{std::string(where) + " is no text"};
  return value.get<std::string>();
}

}  // namespace

const Json& field(const Json& object, const char* key) {
  if (!object.is_object() || !object.contains(key))
    throw NoJournal{std::string(key) + " is missing"};
  return object[key];
}

double number_in(const Json& object, const char* key) {
  const Json& value = field(object, key);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw NoJournal{std::string(key) + " is no number"};
  return value.get<double>();
}

std::uint64_t count_in(const Json& object, const char* key) {
  const Json& value = field(object, key);
  if (!value.is_number_unsigned()) throw NoJournal{std::string(key) + " is no count"};
  return value.get<std::uint64_t>();
}

const Json& list_in(const Json& object, const char* key, std::size_t most) {
  const Json& value = field(object, key);
  if (!value.is_array() || value.size() > most)
    throw NoJournal{std::string(key) + " is no list of at most " + std::to_string(most)};
  return value;
}

std::string text_in(const Json& object, const char* key) {
  const Json& value = field(object, key);
  if (!value.is_object()) return string_of(value, key);
  return narrowed(string_of(field(value, "latin1"), key), key);
}

Json text_json(const std::string& text) {
  if (is_utf8(text)) return text;
  return {{"latin1", widened(text)}};
}

Json axes_json(const base::AxisVector& values) { return values.values; }

base::AxisVector axes_in(const Json& object, const char* key) {
  const Json& list = list_in(object, key, base::kMaxAxes);
  base::AxisVector values;
  if (list.size() != values.values.size()) throw NoJournal{std::string(key) + " lacks an axis"};
  for (std::size_t i = 0; i < list.size(); ++i) {
    values.values[i] = list[i].is_number() ? list[i].get<double>() : kFarthest + 1;
    if (!(std::abs(values.values[i]) <= kFarthest))
      throw NoJournal{std::string(key) + " is no list of positions"};
  }
  return values;
}

Json memory_json(const control::Memory& memory) {
  Json json = Json::parse(state_text(memory));
  Json volatiles = Json::object();
  for (std::size_t i = 0; i < control::kVolatileCommons; ++i) {
    if (!vm::is_null(memory.commons[i]))
      volatiles[std::to_string(kFirstVolatile + i)] = memory.commons[i];
  }
  json["volatile"] = std::move(volatiles);
  return json;
}

control::Memory memory_in(const Json& object, const char* key, control::Memory memory) {
  const Json& json = field(object, key);
  if (auto taken = take_state(json.dump(), memory); !taken)
    throw NoJournal{std::string(key) + ": " + taken.error().message};
  const Json& volatiles = field(json, "volatile");
  for (const auto& [name, value] : volatiles.items()) {
    const auto number = base::read_whole_number(name);
    const std::uint64_t at = number.value_or(0) - kFirstVolatile;
    if (!number || at >= control::kVolatileCommons)
      throw NoJournal{"volatile has no variable " + name};
    memory.commons[at] = number_in(volatiles, name.c_str());
  }
  return memory;
}

}  // namespace kerf::machine
