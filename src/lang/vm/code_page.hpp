#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/block_id.hpp"
#include "base/diagnostic.hpp"
#include "lang/vm/builtin.hpp"
#include "lang/vm/instruction.hpp"

namespace kerf::vm {

/// Which compiled program: an index that the CodeSource gives out.
enum class CodeId : std::uint32_t {};

/// A place in a program's code. Addresses of one program are ordered as its text is.
struct Address {
  std::uint32_t page = 0;
  std::uint32_t instruction = 0;
  friend auto operator<=>(const Address&, const Address&) = default;
};

/// A stretch of code that may only be entered through its head and repeats from its end: DO … END.
struct Region {
  enum class State : std::uint8_t { unresolved, closed, open, crossing };
  std::uint8_t slot = 0;
  State state = State::unresolved;
  std::uint32_t head = 0;  ///< first instruction, of this page
  Address end{};           ///< its repeat_region, when closed
};

/// Where a block of the source begins in the code.
struct BlockMark {
  std::uint32_t instruction = 0;
  std::uint32_t line = 0;         ///< from 1
  std::uint32_t offset = 0;       ///< of the block's first byte, from the start of the page's text
  std::uint32_t line_offset = 0;  ///< of its line's first byte, likewise
  std::uint32_t length = 0;       ///< of the block, in bytes
  std::uint32_t sequence = 0;     ///< its N word; 0: none
};

/// A stretch of a line: what an instruction or a word was made from, for the caret. Every one of
/// them has such a span, so it fits into four bytes.
struct Span {
  static constexpr std::uint32_t kMostColumn = (1U << 21) - 1;
  static constexpr std::uint32_t kMostLength = (1U << 11) - 1;

  std::uint32_t column : 21 = 0;  ///< from 1, in bytes; what is larger reads kMostColumn
  std::uint32_t length : 11 = 0;  ///< in bytes; what is longer reads kMostLength

  /// The text from `begin` to `end` on the line that begins at `line`.
  [[nodiscard]] static Span between(const char* begin, const char* end, const char* line) {
    Span span;
    span.column = at_most(begin - line + 1, kMostColumn) & kMostColumn;
    span.length = at_most(end - begin, kMostLength) & kMostLength;
    return span;
  }

 private:
  static std::uint32_t at_most(std::ptrdiff_t value, std::uint32_t most) {
    return value < 0 ? 0 : static_cast<std::uint32_t>(std::min<std::ptrdiff_t>(value, most));
  }
};

/// The code of some consecutive blocks of a program, together with what maps it back to the text.
/// A front end derives its own page type to keep with it what its blocks hold.
struct CodePage {
  CodePage() = default;
  virtual ~CodePage() = default;
  // Pages change places without their contents being copied.
  CodePage(const CodePage&) = default;
  CodePage& operator=(const CodePage&) = default;
  CodePage(CodePage&&) = default;
  CodePage& operator=(CodePage&&) = default;

  CodeId code{};
  std::uint32_t number = 0;
  base::FileId file = base::kNoFile;
  std::uint64_t text_begin = 0;  ///< byte offset of the page's first block in its file
  std::vector<Instruction> instructions;
  std::vector<Span> spans;  ///< one per instruction
  std::vector<double> constants;
  std::vector<Region> regions;
  std::vector<base::Diagnostic> failures;
  std::vector<BlockMark> marks;  ///< ascending
  const Builtin* builtins = nullptr;

  /// The block that an instruction belongs to, or nullptr in a page without blocks.
  [[nodiscard]] const BlockMark* mark_of(std::uint32_t instruction) const;

  /// The text that an instruction was made from.
  [[nodiscard]] base::Place place_of(std::uint32_t instruction) const;

  /// A block of this page; program and calls are not the page's business.
  [[nodiscard]] base::BlockId id_of(const BlockMark& mark) const {
    return {.file = file,
            .line = mark.line,
            .column = mark.offset - mark.line_offset + 1,
            .from = text_begin + mark.offset,
            .length = mark.length,
            .sequence = mark.sequence};
  }

 protected:
  void clear_code();

  /// Bytes that what is here occupies, for the budget of those who keep pages.
  [[nodiscard]] std::size_t bytes_of_code() const;
  template <typename T>
  [[nodiscard]] static std::size_t bytes_of(const std::vector<T>& items) {
    return items.capacity() * sizeof(T);
  }
};

/// Where the interpreter gets its code from. Pages may be thrown away and made again between two
/// calls: a reference is valid until the next call of any function here.
class CodeSource {
 public:
  virtual ~CodeSource() = default;

  /// Page `number` of a program; asking for one behind the last page is a bug.
  virtual CodePage& page(CodeId code, std::uint32_t number) = 0;

  /// The block with this label: the first behind `from`, or else the first from the program's head.
  virtual std::optional<Address> find_label(CodeId code, Address from, std::uint32_t label) = 0;

  /// Resolves region `region` of a page whose end lies in a later page.
  virtual Region resolve_region(CodeId code, std::uint32_t page, std::uint32_t region) = 0;
};

}  // namespace kerf::vm
