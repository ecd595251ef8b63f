#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "lang/gcode/emitter.hpp"
#include "lang/gcode/expression.hpp"
#include "lang/gcode/keywords.hpp"
#include "lang/gcode/lexer.hpp"
#include "lang/gcode/name_table.hpp"
#include "lang/gcode/statement_parser.hpp"

namespace kerf::gcode {

/// Text of a block and where it stands.
struct BlockText {
  std::string_view text;
  const char* line_begin = nullptr;  ///< first byte of the block's line
  std::uint32_t line = 0;
  std::uint32_t offset = 0;       ///< of the block, from the start of the page's text
  std::uint32_t line_offset = 0;  ///< of the line, likewise
};

/// Compiles one block after the other into a page (docs/dialect.md §1, §4, §5, §7).
///
/// A block with a mistake compiles to an instruction that raises its alarm, so that the alarm comes
/// when the block is reached, as on the control.
class BlockParser {
 public:
  BlockParser(GcodePage& page, NameTable& names)
      : page_(page), emitter_(page), names_(names), statements_(page, emitter_, names) {}

  void compile(const BlockText& block);

  /// A line that is longer than any block can be; its text is not looked at.
  void fail_long_line(std::uint32_t line, std::uint32_t line_offset);

 private:
  // A slash in mid-block: what to land on and how many words stand before it.
  struct MidSkip {
    std::uint32_t instruction = 0;
    std::uint32_t words = 0;
  };

  void block(Cursor& cursor, const BlockText& text);
  std::vector<std::uint32_t> head(Cursor& cursor);
  std::uint8_t skip_level(Cursor& cursor);
  void label(Cursor& cursor);
  void keep_loop_end(const SyntaxError& error, const BlockText& text);
  void report(const SyntaxError& error, const BlockText& text);

  void words(Cursor& cursor);
  bool plain_word(Cursor& cursor);
  void note_g(double code);
  void word(Cursor& cursor);
  void literal(Cursor& cursor, Word& word, bool minus);
  void program_name(Cursor& cursor, Statement& statement);
  void finish_word(const char* begin, const char* end, Word word);
  [[noreturn]] void stray(Cursor& cursor);
  void check_words_first(const Cursor& cursor);
  void do_words(Statement statement, std::uint32_t count);
  void finish_mid_skips(const Statement& statement, const std::vector<MidSkip>& skips);

  GcodePage& page_;
  Emitter emitter_;
  NameTable& names_;
  StatementParser statements_;
  const char* line_begin_ = nullptr;
  std::size_t first_word_ = 0;   // of the block, in the page's words
  bool arguments_ = false;       // the words are arguments of a macro call
  bool may_call_ = false;        // the words hold a code of a macro call, or a G from a variable
  bool from_registers_ = false;  // a word of the block takes its value from a register
};

}  // namespace kerf::gcode
