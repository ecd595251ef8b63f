#include "machine/definition/internal/takes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/decimal.hpp"

namespace kerf::machine {
namespace {

using Form = Takes::Form;

constexpr std::array<std::string_view, 2> kFlagWords = {"false", "true"};

std::optional<double> place_of(std::string_view word, std::span<const std::string_view> words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return {};
  return static_cast<double>(found - words.begin());
}

std::string numbers_in_words(const Takes& takes) {
  const bool above = takes.high == Takes{}.high;
  if (above && takes.low == Takes{}.low) return takes.zero ? "a number" : "a number other than 0";
  if (above) return takes.zero ? "a number that is not negative" : "a positive number";
  return "a number from " + base::number_text(takes.low) + " to " + base::number_text(takes.high);
}

std::string list_of(std::span<const std::string_view> words) {
  std::string list(words.front());
  for (const std::string_view word : words.subspan(1)) {
    list += (word == words.back() ? " or " : ", ") + std::string(word);
  }
  return list;
}

}  // namespace

bool admits(const Takes& takes, double value) {
  if (!(value >= takes.low && value <= takes.high)) return false;
  if (takes.form == Form::whole_number) return value == std::floor(value);
  return takes.zero || value != 0;
}

std::optional<double> value_of(const Takes& takes, std::string_view text) {
  if (takes.form == Form::word) return place_of(text, takes.words);
  if (takes.form == Form::flag) return place_of(text, kFlagWords);
  const auto number = base::read_number(text);
  return number && admits(takes, *number) ? std::optional(*number) : std::nullopt;
}

std::string in_words(const Takes& takes) {
  switch (takes.form) {
    case Form::number: return numbers_in_words(takes);
    case Form::whole_number:
      return "a whole number from " + std::to_string(static_cast<long long>(takes.low)) + " to " +
             std::to_string(static_cast<long long>(takes.high));
    case Form::flag: return "true or false";
    case Form::word: return list_of(takes.words);
  }
  return {};
}

}  // namespace kerf::machine
