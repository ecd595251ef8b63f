#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "lang/gcode/block.hpp"
#include "lang/vm/code_page.hpp"

namespace kerf::gcode {

/// Registers 0 to 33 of a frame are #0 to #33; #0 is null for ever.
inline constexpr std::uint32_t kLocals = 34;

/// #100 to #199 and #500 to #999 are the globals of the virtual machine, in this order.
inline constexpr std::uint32_t kVolatileCommons = 100;
inline constexpr std::uint32_t kRetainedCommons = 500;
inline constexpr std::uint32_t kGlobals = kVolatileCommons + kRetainedCommons;

/// Variables that no program can name by number; the compiler asks the control for them.
inline constexpr std::uint32_t kIncrementOf =
    4'000'000'000U;  ///< + letter: least increment of an address
inline constexpr std::uint32_t kNamed = 3'500'000'000U;  ///< + n: variable with name number n
inline constexpr std::uint32_t kParameter =
    3'000'000'000U;  ///< + 100·number + suffix: PRM[number, …]

/// A part of DPRNT's or BPRNT's list: a character, or a variable with its digits.
struct PrintItem {
  char character = 0;          ///< 0: a variable
  std::uint8_t register_ = 0;  ///< holds its value
  std::uint8_t integers = 0;   ///< digits before the point
  std::uint8_t decimals = 0;   ///< digits behind it
};

/// A name that SETVN gives to a variable.
struct VariableName {
  std::uint32_t number = 0;
  std::string name;
};

enum class StatementKind : std::uint8_t { words, popen, pclos, dprnt, bprnt, setvn };

/// What a do_block instruction executes: a stretch of the page's words, print items or names.
struct Statement {
  StatementKind kind = StatementKind::words;
  bool from_registers = false;  ///< some of the words take their value from a register
  bool may_call = false;        ///< G65, G66, G66.1, G67, or a G whose value is not known yet
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t mark = 0;  ///< index of its block's mark
  std::int32_t name = -1;  ///< index into names: "<NAME>" of a call
};

/// A sequence number and where it stands.
struct Label {
  std::uint32_t number = 0;
  std::uint32_t instruction = 0;
  friend auto operator<=>(const Label&, const Label&) = default;
};

/// A DO or an END in the order of the text.
struct LoopMark {
  std::uint8_t slot = 0;
  bool is_end = false;
  std::uint32_t index = 0;  ///< DO: its region; END: its repeat_region instruction
};

/// A text that belongs to a block: the comment of #3000 and #3006.
struct BlockComment {
  std::uint32_t mark = 0;  ///< index into marks
  std::string text;
};

/// Something the reader should know although the control accepts it.
struct Remark {
  std::uint32_t line = 0;
  const char* what = "";
};

/// The code of a stretch of a FANUC program.
struct GcodePage : vm::CodePage {
  std::vector<Word> words;
  std::vector<Statement> statements;
  std::vector<PrintItem> print_items;
  std::vector<VariableName> variable_names;
  std::vector<std::string> names;
  std::vector<Label> labels;         ///< in the order of the text
  std::vector<LoopMark> loop_marks;  ///< in the order of the text
  std::vector<BlockComment> comments;
  std::vector<Remark> remarks;
  std::uint64_t text_end = 0;   ///< byte offset behind the page's text
  std::uint32_t next_line = 0;  ///< line number there
  bool last = false;            ///< the program ends with this page

  void clear();

  /// The comment of the block that an instruction belongs to; empty without one.
  [[nodiscard]] std::string_view comment_of(std::uint32_t instruction) const;

  /// Bytes that the page occupies, for the budget of those who keep pages.
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace kerf::gcode
