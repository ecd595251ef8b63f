#include "features/merge/text_style.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"

namespace kerf::features {
namespace {

bool is_length(char letter) {
  return std::string_view("XYZUVWIJKR").find(letter) != std::string_view::npos;
}

std::size_t decimals_in(std::string_view value) {
  const std::size_t point = value.find('.');
  return point == std::string_view::npos ? 0 : value.size() - point - 1;
}

bool is_motion(const BlockWord& word) {
  const auto number = word.number();
  return word.letter == 'G' && number && *number >= 0 && *number <= 3 &&
         *number == std::floor(*number);
}

const BlockWord* motion_in(const std::vector<BlockWord>& words) {
  const auto found = std::find_if(words.begin(), words.end(), is_motion);
  return found == words.end() ? nullptr : &*found;
}

}  // namespace

void TextStyle::look_at(std::string_view block, const std::vector<BlockWord>& words) {
  if (words.empty()) return;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char letter = block[words[i].begin];
    (letter >= 'a' && letter <= 'z' ? lower_ : upper_) += 1;
    if (i > 0) (block[words[i].begin - 1] == ' ' ? blanks_ : tight_) += 1;
    if (words[i].letter == 'G') (words[i].value.size() == 1 ? one_digit_ : two_digits_) += 1;
    if (is_length(words[i].letter)) look_at_number(words[i]);
  }
  const BlockWord* const label = find(words, 'N');
  (label != nullptr ? numbered_ : unnumbered_) += 1;
  if (label != nullptr && label->number()) numbers_.push_back(*label->number());
  look_at_arc(words);
  look_at_habits(words);
}

void TextStyle::look_at_number(const BlockWord& word) {
  const auto value = word.number();
  if (!value) return;
  const std::size_t point = word.value.find('.');
  if (*value != 0) (point == std::string::npos ? pointless_ : pointed_) += 1;
  if (point == std::string::npos) {
    ++plain_whole_;
    return;
  }
  const std::size_t count = decimals_in(word.value);
  decimals_[std::min(count, decimals_.size() - 1)] += 1;
  if (*value == std::floor(*value)) ++points_;
  if (*value != 0 && std::fabs(*value) < 1) {
    const bool has_zero = point > 0 && word.value[point - 1] == '0';
    (has_zero ? zero_points_ : bare_points_) += 1;
  }
}

void TextStyle::look_at_arc(const std::vector<BlockWord>& words) {
  const BlockWord* const i = find(words, 'I');
  const BlockWord* const j = find(words, turns ? 'K' : 'J');
  if (i == nullptr && j == nullptr) {
    const BlockWord* const code = motion_in(words);
    if (code != nullptr && *code->number() >= 2 && find(words, 'R') != nullptr) ++radii_;
    return;
  }
  ++centres_;
  if (i == nullptr || j == nullptr) {
    ++bare_centres_;
  } else if (i->number() == 0.0 || j->number() == 0.0) {
    ++zero_centres_;
  }
}

void TextStyle::look_at_habits(const std::vector<BlockWord>& words) {
  const BlockWord* const x = find(words, 'X');
  const BlockWord* const y = find(words, turns ? 'Z' : 'Y');
  if (x == nullptr && y == nullptr) return;
  const BlockWord* const code = motion_in(words);
  const bool is_arc = find(words, 'I') != nullptr || find(words, turns ? 'K' : 'J') != nullptr ||
                      (code != nullptr && *code->number() >= 2);
  if (code != nullptr && *code->number() == 0) return;
  Habits& habits = habits_[is_arc ? 1 : 0];
  (code != nullptr ? habits.repeats_code : habits.omits_code) += 1;
  (x != nullptr && y != nullptr ? habits.repeats_axes : habits.omits_axes) += 1;
  (find(words, 'F') != nullptr ? habits.repeats_feed : habits.omits_feed) += 1;
}

double TextStyle::half_step() const {
  std::vector<double> steps;
  for (std::size_t i = 1; i < numbers_.size(); ++i) {
    if (numbers_[i] > numbers_[i - 1]) steps.push_back(numbers_[i] - numbers_[i - 1]);
  }
  if (steps.empty()) return 5;
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                   steps.end());
  return std::max(1.0, std::floor(steps[steps.size() / 2] / 2));
}

std::string TextStyle::written(double value, bool has_point, int least, bool has_zero) const {
  if (!has_point && pointless > 0) return base::rounded_text(std::round(value / pointless), 0);
  std::string text = base::rounded_text(value, most_decimals);
  const bool has_fraction = text.find('.') != std::string::npos;
  if (!has_fraction && !has_point) return text;
  if (!has_fraction) text += '.';
  while (static_cast<int>(decimals_in(text)) < least) text += '0';
  if (has_zero) return text;
  const std::size_t zero = text.find("0.");
  const bool is_leading = zero == 0 || (zero == 1 && text[0] == '-');
  if (is_leading && text.size() > zero + 2) text.erase(zero, 1);
  return text;
}

// Where a number without a point counts increments, few write one for a length.
bool TextStyle::has_points() const {
  return pointless > 0 ? pointed_ >= pointless_ : points_ > plain_whole_;
}

std::string TextStyle::number(double value) const {
  const auto most = std::max_element(decimals_.begin(), decimals_.end());
  const int total = decimals_[0] + decimals_[1] + decimals_[2] + decimals_[3] + decimals_[4];
  const bool is_fixed = *most > 0 && 10 * *most >= 9 * total && most != decimals_.begin();
  const int least = is_fixed ? static_cast<int>(most - decimals_.begin()) : 0;
  return written(value, has_points(), least, zero_points_ >= bare_points_);
}

std::string TextStyle::number_like(std::string_view old, double value) const {
  const std::size_t point = old.find('.');
  const auto before = base::read_number(old);
  // 0 says nothing of what a number without a point counts.
  const bool has_point =
      point != std::string_view::npos || (pointless > 0 && before == 0.0 && has_points());
  const std::size_t digits = old.find_first_of("0123456789.");
  const bool begins_bare = digits != std::string_view::npos && old[digits] == '.';
  const bool was_fraction = before && std::fabs(*before) < 1 && *before != 0;
  const bool has_zero = was_fraction ? !begins_bare : zero_points_ >= bare_points_;
  const bool ends_in_zero = has_point && !old.empty() && old.back() == '0';
  const int least = ends_in_zero ? static_cast<int>(decimals_in(old)) : 0;
  return written(value, has_point, least, has_zero);
}

std::string TextStyle::word(char letter, double value) const {
  const char shown = lower_ > upper_ ? static_cast<char>(letter - 'A' + 'a') : letter;
  return std::string(1, shown) + number(value);
}

std::string TextStyle::motion_word(int code) const {
  const char shown = lower_ > upper_ ? 'g' : 'G';
  const std::string zero = two_digits_ >= one_digit_ ? "0" : "";
  return std::string(1, shown) + zero + std::to_string(code);
}

}  // namespace kerf::features
