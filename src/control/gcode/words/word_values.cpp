#include "control/gcode/words/word_values.hpp"

#include <cmath>

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr double kPerMillimetre = 1000;  // least increments, IS-B
constexpr double kPerInch = 10000;
constexpr double kMostIncrements = 1e9;  // more than 9 digits (LEX-28)
constexpr double kTieGuard = 1e-6;  // of an increment: 1.2345 is stored as 1.23449999… (NUM-14)

}  // namespace

bool WordValues::too_large(const Word& word) {
  if (word.has(WordFlag::literal)) return alarms_.raise(Code::too_many_digits, word.text);
  return alarms_.raise(Code::improper_address_word, word.text,
                       "the value is " + base::number_text(word.value));
}

// The word's value in least increments, a whole number.
bool WordValues::increments(const Word& word, double per_unit, double& count) {
  const bool counts_increments =
      word.has(WordFlag::literal) && !word.has(WordFlag::point) && !format_.calculator_point;
  const double scaled = counts_increments ? word.value : word.value * per_unit;
  if (!(scaled < kMostIncrements && scaled > -kMostIncrements)) return too_large(word);
  count = static_cast<double>(base::round_away(scaled + (scaled < 0 ? -kTieGuard : kTieGuard)));
  return true;
}

bool WordValues::length(const Word& word, double& mm) {
  double count = 0;
  if (!increments(word, format_.inch ? kPerInch : kPerMillimetre, count)) return false;
  // Whole numbers divided once: the double nearest to the decimal.
  mm = format_.inch ? count * 254 / 100000 : count / kPerMillimetre;
  return true;
}

bool WordValues::angle(const Word& word, double& degrees) {
  double count = 0;
  if (!increments(word, kPerMillimetre, count)) return false;
  degrees = count / kPerMillimetre;
  return true;
}

bool WordValues::integer(const Word& word, std::int64_t low, std::int64_t high,
                         std::int64_t& value) {
  if (word.has(WordFlag::point)) return alarms_.raise(Code::illegal_decimal_point, word.text);
  if (low >= 0 && word.value < 0) return alarms_.raise(Code::illegal_minus, word.text);
  if (!(std::fabs(word.value) < kMostIncrements)) return too_large(word);
  value = base::round_away(word.value);
  if (value >= low && value <= high) return true;
  return alarms_.raise(Code::improper_address_word, word.text,
                       std::to_string(low) + " to " + std::to_string(high) + " is allowed");
}

bool WordValues::plain(const Word& word, double& value) {
  if (!(std::fabs(word.value) < kMostIncrements)) return too_large(word);
  value = word.value;
  return true;
}

double WordValues::increment(char letter, bool rotary) const {
  switch (letter) {
    case 'D':
    case 'F':
    case 'G':
    case 'H':
    case 'L':
    case 'M':
    case 'N':
    case 'O':
    case 'P':
    case 'S':
    case 'T': return 1;
    case 'A':
    case 'B':
    case 'C': return rotary || !format_.inch ? 0.001 : 0.0001;
    default: return format_.inch && !rotary ? 0.0001 : 0.001;
  }
}

}  // namespace kerf::control
