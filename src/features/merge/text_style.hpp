#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/merge/block_words.hpp"

namespace kerf::features {

/// How a program writes numbers, letters and words, by majority (features-contract §8.4).
class TextStyle {
 public:
  /// Takes a block into account, as often as there are.
  void look_at(std::string_view block, const std::vector<BlockWord>& words);

  /// Digits behind the point: 3 in mm, 4 in inches.
  int most_decimals = 3;
  /// What a number without a point counts, in units of the program; 0: as with a point.
  double pointless = 0;

  bool turns = false;  ///< of a lathe: X and Z are the axes of its plane

  /// A number as the words of the program have it.
  [[nodiscard]] std::string number(double value) const;
  /// A number in the place of `old`, with its point, zeros and digits.
  [[nodiscard]] std::string number_like(std::string_view old, double value) const;
  /// A letter with a number, and G with its digits.
  [[nodiscard]] std::string word(char letter, double value) const;
  [[nodiscard]] std::string motion_word(int code) const;
  /// Stands between words.
  [[nodiscard]] std::string between() const { return blanks_ > tight_ ? " " : ""; }

  /// Of lines and of arcs.
  struct Habits {
    int repeats_code = 0, omits_code = 0;
    int repeats_axes = 0, omits_axes = 0;
    int repeats_feed = 0, omits_feed = 0;
  };
  [[nodiscard]] const Habits& habits(bool is_arc) const { return habits_[is_arc ? 1 : 0]; }
  [[nodiscard]] bool writes_zero_centres() const { return zero_centres_ >= bare_centres_; }
  [[nodiscard]] bool writes_radius() const { return radii_ > centres_; }
  [[nodiscard]] bool is_numbered() const { return numbered_ > unnumbered_; }
  /// Half of the usual step between N words.
  [[nodiscard]] double half_step() const;

 private:
  [[nodiscard]] bool has_points() const;
  void look_at_number(const BlockWord& word);
  void look_at_arc(const std::vector<BlockWord>& words);
  void look_at_habits(const std::vector<BlockWord>& words);
  [[nodiscard]] std::string written(double value, bool has_point, int least, bool has_zero) const;

  int blanks_ = 0, tight_ = 0;
  int lower_ = 0, upper_ = 0;
  int two_digits_ = 0, one_digit_ = 0;
  int pointed_ = 0, pointless_ = 0;   // of all but 0
  int points_ = 0, plain_whole_ = 0;  // of whole numbers
  int bare_points_ = 0;               // ".5"
  int zero_points_ = 0;               // "0.5"
  std::array<int, 6> decimals_{};     // of numbers with a point
  int zero_centres_ = 0, bare_centres_ = 0, radii_ = 0, centres_ = 0;
  int numbered_ = 0, unnumbered_ = 0;
  std::array<Habits, 2> habits_{};
  std::vector<double> numbers_{};  // N words in their order
};

}  // namespace kerf::features
