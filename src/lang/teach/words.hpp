#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace kerf::teach {

/// What stands between words. A stray CR at either end of a line is a blank.
inline constexpr std::string_view kBetweenWords = " \t\v\f\r,";
inline constexpr char kCommentMark = ';';

/// The words of one line: what stands between blanks and commas, and the comment behind them. Views
/// into the line.
class Words {
 public:
  /// Words that are kept; of more than the longest record has only the count is known.
  static constexpr std::size_t kMost = 12;

  explicit Words(std::string_view line);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::string_view operator[](std::size_t i) const { return words_[i]; }
  [[nodiscard]] std::span<const std::string_view> kept() const {
    return {words_.data(), std::min(count_, kMost)};
  }
  [[nodiscard]] bool has_comment() const { return has_comment_; }
  /// What follows the semicolon.
  [[nodiscard]] std::string_view comment() const { return comment_; }

 private:
  std::array<std::string_view, kMost> words_;
  std::size_t count_ = 0;
  std::string_view comment_;
  bool has_comment_ = false;
};

/// Whether two words are the same but for the case of their letters. `capitals` is in capitals.
[[nodiscard]] bool same_word(std::string_view word, std::string_view capitals);

}  // namespace kerf::teach
