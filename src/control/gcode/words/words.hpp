#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/decimal.hpp"
#include "control/gcode/codes/code_table.hpp"
#include "lang/gcode/block.hpp"

namespace kerf::control {

/// Number of an M code, or of any whole-numbered word.
[[nodiscard]] inline std::int64_t code_of(const gcode::Word& word) {
  return base::round_away(word.value);
}

/// The words of a block by address: of each letter the last one (LEX-31), of G and M all of them.
/// Points into the block that it was made from.
class Words {
 public:
  static constexpr std::size_t kMostG = 16;
  static constexpr std::size_t kMostM = 8;

  struct G {
    GCode code = 0;
    const CodeRow* row = nullptr;  ///< null: the dialect has no such code
    const gcode::Word* word = nullptr;

    [[nodiscard]] Group group() const { return row == nullptr ? Group::none : row->group; }
    [[nodiscard]] Meaning meaning() const { return row == nullptr ? Meaning::none : row->meaning; }
  };
  struct M {
    const FunctionRow* row = nullptr;  ///< null: the control passes it on
    const gcode::Word* word = nullptr;

    [[nodiscard]] Function function() const {
      return row == nullptr ? Function::passed_on : row->function;
    }
  };

  /// Letters that the block holds, one bit each; G and M included.
  [[nodiscard]] bool has(char letter) const { return (present_ >> bit(letter) & 1U) != 0; }
  [[nodiscard]] bool has_any(std::uint32_t letters) const { return (present_ & letters) != 0; }
  [[nodiscard]] std::uint32_t present() const { return present_; }
  /// The last word with this letter. Precondition: has(letter).
  [[nodiscard]] const gcode::Word& operator[](char letter) const { return *last_[bit(letter)]; }
  [[nodiscard]] const gcode::Word* find(char letter) const {
    return has(letter) ? last_[bit(letter)] : nullptr;
  }

  [[nodiscard]] bool has_g(Meaning meaning) const {
    return std::any_of(g_begin(), g_end(), [=](const G& g) { return g.meaning() == meaning; });
  }
  [[nodiscard]] const G* g_begin() const { return g_.data(); }
  [[nodiscard]] const G* g_end() const { return g_.data() + g_count_; }
  [[nodiscard]] const M* m_begin() const { return m_.data(); }
  [[nodiscard]] const M* m_end() const { return m_.data() + m_count_; }

  void clear() { present_ = 0, g_count_ = 0, m_count_ = 0; }
  void put(const gcode::Word& word) {
    present_ |= 1U << bit(word.letter);
    last_[bit(word.letter)] = &word;
  }
  [[nodiscard]] bool put_g(GCode code, const CodeRow* row, const gcode::Word& word) {
    if (g_count_ == kMostG) return false;
    g_[g_count_++] = {code, row, &word};
    put(word);
    return true;
  }
  [[nodiscard]] bool put_m(const FunctionRow* row, const gcode::Word& word) {
    if (m_count_ == kMostM) return false;
    m_[m_count_++] = {row, &word};
    put(word);
    return true;
  }

  /// Takes a letter out; its word counts as not written.
  void forget(char letter) { present_ &= ~mask(letter); }

  static constexpr std::uint32_t mask(char letter) { return 1U << bit(letter); }
  static constexpr std::uint32_t mask(std::string_view letters) {
    std::uint32_t all = 0;
    for (const char letter : letters) all |= mask(letter);
    return all;
  }

 private:
  static constexpr unsigned bit(char letter) { return static_cast<unsigned>(letter - 'A'); }

  std::uint32_t present_ = 0;
  std::uint8_t g_count_ = 0;
  std::uint8_t m_count_ = 0;
  std::array<const gcode::Word*, 26> last_;
  std::array<G, kMostG> g_;
  std::array<M, kMostM> m_;
};

}  // namespace kerf::control
