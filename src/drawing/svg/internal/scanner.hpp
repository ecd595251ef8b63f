#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace kerf::drawing::svg {

/// Reads numbers and words from a value of an attribute, one after the other.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] bool is_done() const { return at_ >= text_.size(); }
  /// 0 at the end.
  [[nodiscard]] char peek() const { return is_done() ? '\0' : text_[at_]; }
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  void advance(std::size_t count = 1) { at_ += count; }
  void skip_blanks();
  /// Blanks with at most one comma among them.
  void skip_comma();
  [[nodiscard]] bool take(char mark);

  [[nodiscard]] bool is_at_number() const;
  /// What is too large for a double is infinite. None: there is no number; nothing is taken then.
  [[nodiscard]] std::optional<double> number();
  /// 0 or 1, which need no blank behind it.
  [[nodiscard]] std::optional<bool> flag();
  /// Letters, digits, '-', '_' and what is no ASCII; may be empty.
  [[nodiscard]] std::string_view word();

 private:
  [[nodiscard]] char look(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// ASCII letters alone change.
[[nodiscard]] bool same_letters(std::string_view a, std::string_view b);
/// The name behind the mark of `#name` or `url(#name)`, blanks and quotes around dropped; none for
/// what is no reference into the same file.
[[nodiscard]] std::optional<std::string_view> local_reference(std::string_view text);

/// All of the text: numbers parted by blanks and commas. None, where there is anything else.
[[nodiscard]] std::optional<std::vector<double>> numbers_of(std::string_view text);

}  // namespace kerf::drawing::svg
