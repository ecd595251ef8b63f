#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "lang/vm/code_page.hpp"

namespace kerf::basic {

/// Variables that live in registers: the first ones of a program. The others are globals of the
/// virtual machine. GOSUB shares the registers of its caller, so both are the same to a program.
inline constexpr std::uint32_t kNear = 80;

/// What the host is asked for by `read`, besides variables that were never written, which it is
/// asked for by their number.
enum class Inquiry : std::uint32_t { x = 1U << 30, y, z, moved, input };

/// What a do_block instruction executes.
enum class StatementKind : std::uint8_t {
  print,
  prompt,  ///< of INPUT
  home,
  speed,
  power,
  move,
  line,
  arc,
  circle,
  wait,
  burn,
  pulse,
  air,
  end
};

/// A part of PRINT's list.
struct PrintItem {
  enum class Kind : std::uint8_t { number, text, comma, semicolon, new_line };
  Kind kind = Kind::new_line;
  std::uint8_t register_ = 0;  ///< of a number
  std::uint32_t text = 0;      ///< index into texts
};

/// Arguments stand in consecutive registers from `first` on; of print and prompt `first` and
/// `count` are a stretch of the page's items.
struct Statement {
  StatementKind kind = StatementKind::end;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool goes_on = false;  ///< of print: the rest of the same statement
};

/// A place that jumps lead to.
struct Label {
  std::uint32_t number = 0;
  std::uint32_t instruction = 0;
  friend auto operator<=>(const Label&, const Label&) = default;
};

/// The code of a stretch of a laser BASIC program.
struct BasicPage : vm::CodePage {
  std::vector<Statement> statements;
  std::vector<PrintItem> items;
  std::vector<std::string> texts;
  std::vector<Label> labels;

  void clear();
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace kerf::basic
