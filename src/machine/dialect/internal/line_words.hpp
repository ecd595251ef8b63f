#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::machine {

/// A word of G-code as it is looked at before anything is compiled.
struct LookedAtWord {
  char letter = 0;        ///< upper case
  double value = 0;       ///< 0 where it is no number: X#1
  std::string_view text;  ///< "T0101"
};

/// The words of one line of G-code, in their order, up to a semicolon, behind which others write
/// comments. Words behind a comma (`,C2.`) and those of macro statements are none. The line must
/// outlive this.
class LineWords {
 public:
  explicit LineWords(std::string_view line);

  [[nodiscard]] const std::vector<LookedAtWord>& all() const { return words_; }
  /// Of several the last one; null: there is none.
  [[nodiscard]] const LookedAtWord* find(char letter) const;
  [[nodiscard]] bool has(char letter) const { return (letters_ & bit(letter)) != 0; }
  [[nodiscard]] bool has_any(std::string_view letters) const;
  [[nodiscard]] bool has_all(std::string_view letters) const;
  /// The G word of this number times ten: 541 is G54.1.
  [[nodiscard]] const LookedAtWord* find_code(int number) const;
  [[nodiscard]] bool has_code(int number) const { return find_code(number) != nullptr; }

 private:
  static std::uint32_t bit(char letter) { return 1U << static_cast<unsigned>(letter - 'A'); }

  std::vector<LookedAtWord> words_;
  std::uint32_t letters_ = 0;
};

/// The number of a code, times `scale`; nothing: it is no number of a code.
[[nodiscard]] std::optional<std::int64_t> code_number(double value, int scale = 1);

}  // namespace kerf::machine
