#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "lang/basic/expression.hpp"

namespace kerf::basic {

/// Compiles lines of a program into a page. A statement that is wrong becomes an instruction that
/// fails when it is reached; what stands behind it on the line is not compiled, but for an ELSE.
class LineCompiler {
 public:
  /// `start` is where the page begins, `early` what the first page has found to be written early;
  /// nothing for that page itself. Page and scan must outlive the compiler.
  LineCompiler(BasicPage& page, const Scan& scan, const PageStart& start,
               std::optional<Emitter::Known> early)
      : page_(page), emitter_(page, scan, early), loops_(start.loops), nexts_(start.nexts) {}

  /// A line and where it is: its number, and the offset of its first byte in the page's text.
  struct Line {
    std::string_view text;
    std::uint32_t number = 0;
    std::uint32_t offset = 0;
  };
  void compile(const Line& line);
  /// A line that is longer than any can be.
  void fail_long_line(const Line& line);
  [[nodiscard]] Emitter::Known early() const { return emitter_.early(); }

 private:
  /// What ends a list of statements besides the end of the line.
  enum class Within : std::uint8_t { line, condition };

  void label(TokenStream& tokens);
  void statements(TokenStream& tokens, Within within);
  void statement(TokenStream& tokens, Within within);
  /// Compiles a part of the line, or makes an instruction that fails of it and leaves it.
  template <typename Part>
  void attempt(TokenStream& tokens, Within within, const Part& part);
  void leave(TokenStream& tokens, Within within);
  static void expect_end(const TokenStream& tokens);
  void begin_statement(const Token& first);
  /// Ways part or meet: what follows is not certain to run with what came before.
  void begin_stretch() {
    steps_ = kNoSteps;
    emitter_.part_ways();
  }
  void report(const SyntaxError& error);

  void command(TokenStream& tokens, const Token& first);
  void assignment(TokenStream& tokens, const Token& name);
  void let(TokenStream& tokens);
  void print(TokenStream& tokens, const Token& first);
  void print_item(TokenStream& tokens);
  void flush_print(const Token& first, bool goes_on);
  void input(TokenStream& tokens, const Token& first);
  void if_statement(TokenStream& tokens);
  void branch_of_if(TokenStream& tokens);
  void for_statement(TokenStream& tokens, const Token& first);
  void next(TokenStream& tokens, const Token& first);
  void jump(TokenStream& tokens, vm::Op op, const Token& first);
  void jump_to(const Token& target, vm::Op op, const Token& first);
  void return_from_call(const TokenStream& tokens, const Token& first);
  void local(TokenStream& tokens, const Token& first);
  void machine_statement(TokenStream& tokens, const Token& first);
  void host_statement(const Token& first, StatementKind kind, std::uint32_t begin,
                      std::uint32_t count, bool goes_on = false);
  [[nodiscard]] std::uint32_t text(const std::string& text);

  static constexpr std::uint32_t kNoSteps = ~0U;

  BasicPage& page_;
  Emitter emitter_;
  Line line_;
  std::uint32_t loops_;             // FORs before the next one
  std::uint32_t nexts_;             // NEXTs before the next one
  std::uint32_t steps_ = kNoSteps;  // the count_steps of the stretch that is compiled
  int ifs_ = 0;                     // within each other on this line
  int unread_ifs_ = 0;              // whose condition is not compiled yet
  std::uint32_t first_item_ = 0;    // of the PRINT that is compiled
};

}  // namespace kerf::basic
