#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kerf::machine {

/// What a key of a machine file takes. Every value is a number: of a flag 0 or 1, of a word its
/// place in the list.
struct Takes {
  enum class Form : std::uint8_t { number, whole_number, flag, word };

  Form form = Form::number;
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  bool zero = true;  ///< whether 0 is one of the numbers
  std::span<const std::string_view> words{};
};

/// Finite numbers.
constexpr Takes numbers(double low, double high) { return {.low = low, .high = high}; }
constexpr Takes any_number() { return {}; }
constexpr Takes any_but_zero() { return {.zero = false}; }
constexpr Takes positive() { return {.low = 0, .zero = false}; }
constexpr Takes not_negative() { return {.low = 0}; }
constexpr Takes whole_numbers(double low, double high) {
  return {.form = Takes::Form::whole_number, .low = low, .high = high};
}
constexpr Takes flag() { return {.form = Takes::Form::flag}; }
constexpr Takes one_of(std::span<const std::string_view> words) {
  return {.form = Takes::Form::word, .words = words};
}

/// Whether `value` is a number that the key takes.
[[nodiscard]] bool admits(const Takes& takes, double value);

/// The value that `text` writes out, or nothing when the key does not take it.
[[nodiscard]] std::optional<double> value_of(const Takes& takes, std::string_view text);

/// For a sentence: "a positive number", "planned, tail or equal".
[[nodiscard]] std::string in_words(const Takes& takes);

}  // namespace kerf::machine
