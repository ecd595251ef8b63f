#pragma once

#include <cstdint>

#include "control/core/alarms.hpp"
#include "control/gcode/words/words.hpp"

namespace kerf::control {

/// Unit in which the numbers of a block count (docs/dialect.md §1.5).
struct NumberFormat {
  bool inch = false;
  bool calculator_point = false;  ///< DPI
};

/// Turns words into values. Every function raises an alarm and returns false when the word does not
/// hold what its address takes: PS0003, PS0006, PS0007, PS1305.
class WordValues {
 public:
  explicit WordValues(Alarms& alarms) : alarms_(alarms) {}

  void set_format(const NumberFormat& format) { format_ = format; }
  [[nodiscard]] const NumberFormat& format() const { return format_; }

  /// mm, rounded to the least increment of the input unit (NUM-14).
  [[nodiscard]] bool length(const gcode::Word& word, double& mm);
  /// Degrees, rounded to 0.001.
  [[nodiscard]] bool angle(const gcode::Word& word, double& degrees);
  /// A whole number from `low` to `high`; a variable or bracket is rounded (NUM-16).
  [[nodiscard]] bool integer(const gcode::Word& word, std::int64_t low, std::int64_t high,
                             std::int64_t& value);
  /// A number as it is, without scaling.
  [[nodiscard]] bool plain(const gcode::Word& word, double& value);

  /// Least increment of an address in the program's own unit: mm, inch or degrees; 1 for integers.
  [[nodiscard]] double increment(char letter, bool rotary) const;

 private:
  bool increments(const gcode::Word& word, double per_unit, double& count);
  bool too_large(const gcode::Word& word);

  Alarms& alarms_;
  NumberFormat format_;
};

}  // namespace kerf::control
