// Tokens of whole programs: nothing is left out, and they are what the compilers read.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <set>
#include <sstream>

#include "base/text_window.hpp"
#include "drive/pattern/listing.hpp"
#include "lang/basic/basic_program.hpp"
#include "lang/gcode/code_library.hpp"
#include "lang/teach/teach_library.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::test {
namespace {

using base::Token;
using base::TokenKind;
using machine::DialectRow;

/// A program with the tokens of each of its lines.
struct CutProgram {
  std::string path;
  const DialectRow* dialect = nullptr;
  std::vector<std::string> lines;
  std::vector<std::vector<Token>> tokens;
};

CutProgram cut(const std::string& path) {
  const auto file = *base::SourceFile::open(path);
  const DialectRow* shown = machine::dialect_by_ending(path);
  if (shown == nullptr) shown = machine::dialect_by_text(*file);
  CutProgram program{path, shown == nullptr ? &machine::usual_dialect() : shown, {}, {}};
  base::TextWindow window;
  window.stand_at(*file, base::FileId{0}, 0, file->size());
  for (base::TextWindow::Line line; window.next(line);) {
    program.lines.emplace_back(line.text);
    const auto text = line.offset == 0 ? base::without_byte_order_mark(line.text) : line.text;
    auto tokens = base::tokens_of(*program.dialect->language, text);
    const auto mark = static_cast<std::uint32_t>(line.text.size() - text.size());
    for (Token& token : tokens) token.begin += mark;
    program.tokens.push_back(std::move(tokens));
  }
  return program;
}

const std::vector<CutProgram>& all_programs() {
  static const std::vector<CutProgram> programs = [] {
    std::vector<std::string> paths;
    for (const char* const folder : {KERF_TEXT_TESTS, KERF_EXAMPLES}) {
      for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string ending = entry.path().extension();
        if (ending == ".nc" || ending == ".bas" || ending == ".tch")
          paths.push_back(entry.path().string());
      }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<CutProgram> found;
    for (const std::string& path : paths) found.push_back(cut(path));
    return found;
  }();
  return programs;
}

TEST(Tokens, OfEachProgramHoldEachByteOnce) {
  std::size_t bytes = 0;
  for (const CutProgram& program : all_programs()) {
    for (std::size_t i = 0; i < program.lines.size(); ++i) {
      std::size_t at =
          program.tokens[i].empty() ? program.lines[i].size() : program.tokens[i].front().begin;
      ASSERT_TRUE(at == 0 || i == 0 || program.lines[i].empty()) << program.path << ":" << i + 1;
      for (const Token& token : program.tokens[i]) {
        ASSERT_EQ(token.begin, at) << program.path << ":" << i + 1;
        ASSERT_GT(token.length, 0U) << program.path << ":" << i + 1;
        at += token.length;
      }
      ASSERT_EQ(at, program.lines[i].size()) << program.path << ":" << i + 1;
      bytes += at;
    }
  }
  EXPECT_GT(all_programs().size(), 1200U);
  EXPECT_GT(bytes, 200'000U);
}

/// A stretch of a line that a compiler has read as one thing.
struct Read {
  std::size_t line = 0;  // from 1
  std::size_t begin = 0;
  std::size_t end = 0;
};

// The token that begins there, null: none does.
const Token* token_at(const CutProgram& program, std::size_t line, std::size_t begin) {
  const auto& tokens = program.tokens.at(line - 1);
  const auto found = std::find_if(tokens.begin(), tokens.end(),
                                  [&](const Token& token) { return token.begin == begin; });
  return found == tokens.end() ? nullptr : &*found;
}

bool ends_a_token(const CutProgram& program, const Read& read) {
  return std::any_of(program.tokens[read.line - 1].begin(), program.tokens[read.line - 1].end(),
                     [&](const Token& token) { return token.begin + token.length == read.end; });
}

// Instructions that never raise an alarm keep the stretch of whatever was emitted before; that of a
// slash leaves out its level.
bool has_a_place(vm::Op op) {
  constexpr std::array kWithout = {
      vm::Op::fail, vm::Op::move,         vm::Op::load_constant, vm::Op::store_global, vm::Op::jump,
      vm::Op::note, vm::Op::enter_region, vm::Op::leave_region,  vm::Op::skip_when_on};
  return std::find(kWithout.begin(), kWithout.end(), op) == kWithout.end();
}

// Kinds of the tokens within, blanks and comments left out.
std::set<TokenKind> kinds_within(const CutProgram& program, const Read& read) {
  std::set<TokenKind> kinds;
  for (const Token& token : program.tokens[read.line - 1]) {
    if (token.begin >= read.begin && token.begin < read.end) kinds.insert(token.kind);
  }
  kinds.erase(TokenKind::blank);
  kinds.erase(TokenKind::comment);
  return kinds;
}

Read read_of(const vm::Span& span, std::uint32_t line) {
  return {line, span.column - 1U, span.column - 1U + span.length};
}

bool is_told(const vm::Span& span) {
  return span.column > 0 && span.length > 0 && span.length < vm::Span::kMostLength;
}

std::string shown(const CutProgram& program, const Read& read) {
  const std::string& line = program.lines[read.line - 1];
  return program.path + ":" + std::to_string(read.line) + ": '" +
         line.substr(std::min(read.begin, line.size()), read.end - read.begin) + "' in " + line;
}

/// Looks at all that the compilers note of a program.
class Agreement {
 public:
  explicit Agreement(const CutProgram& program) : program_(program) {
    file_ = sources_.add(*base::SourceFile::open(program.path));
  }

  std::size_t check() {
    switch (program_.dialect->kind) {
      case DialectRow::Kind::gcode: check_gcode(); break;
      case DialectRow::Kind::basic: check_basic(); break;
      case DialectRow::Kind::teach: check_teach(); break;
      case DialectRow::Kind::motion:
      case DialectRow::Kind::pattern: break;
    }
    return count_;
  }

 private:
  void check_gcode() {
    gcode::CodeLibrary library(sources_);
    library.add_file(file_);
    for (std::size_t program = 0; program < library.program_count(); ++program) {
      for (std::uint32_t number = 0;; ++number) {
        const auto& page = library.page(static_cast<vm::CodeId>(program), number);
        check_page(page);
        check_words(page);
        if (page.last) break;
      }
    }
  }

  void check_basic() {
    basic::BasicProgram program(sources_, {});
    program.load(file_);
    for (std::uint32_t number = 0;; ++number) {
      const auto& page = program.page(basic::BasicProgram::kCode, number);
      check_page(page);
      if (page.instructions.back().op == vm::Op::end_of_code) break;
    }
  }

  void check_teach() {
    teach::TeachLibrary library(sources_, {});
    library.load(file_);
    for (std::uint32_t number = 0;; ++number) {
      const auto& page = library.page(teach::TeachLibrary::kProgram, number);
      check_page(page);
      for (std::uint32_t i = 0; i < page.instructions.size(); ++i) {
        if (page.instructions[i].op != vm::Op::do_block) continue;
        for (const vm::Span& span : page.blocks[page.instructions[i].n].words) {
          if (is_told(span)) expect_one_token(read_of(span, page.mark_of(i)->line));
        }
      }
      if (page.last) break;
    }
  }

  // Every stretch that an instruction was made from is made of whole tokens.
  void check_page(const vm::CodePage& page) {
    for (std::uint32_t i = 0; i < page.instructions.size(); ++i) {
      const vm::BlockMark* const mark = page.mark_of(i);
      if (mark != nullptr && is_told(page.spans[i]) && has_a_place(page.instructions[i].op))
        check_instruction(page.instructions[i], read_of(page.spans[i], mark->line));
    }
  }

  void check_instruction(const vm::Instruction& instruction, const Read& read) {
    const bool is_gcode = program_.dialect->kind == DialectRow::Kind::gcode;
    if (is_gcode && instruction.op == vm::Op::do_block) return;  // its words are looked at
    EXPECT_NE(token_at(program_, read.line, read.begin), nullptr) << shown(program_, read);
    EXPECT_TRUE(ends_a_token(program_, read)) << shown(program_, read);
    EXPECT_FALSE(kinds_within(program_, read).contains(TokenKind::error)) << shown(program_, read);
    if (is_gcode && instruction.op == vm::Op::jump_to_label && instruction.c == 1) {
      EXPECT_EQ(kinds_within(program_, read), std::set{TokenKind::target}) << shown(program_, read);
    }
    ++count_;
  }

  // A word is one token, or the pieces of its number and the tokens of its expression.
  void check_words(const gcode::GcodePage& page) {
    for (const gcode::Statement& statement : page.statements) {
      if (statement.kind != gcode::StatementKind::words) continue;
      for (std::uint32_t i = 0; i < statement.count; ++i)
        check_word(page.words[statement.first + i], page.marks[statement.mark].line);
    }
  }

  void check_word(const gcode::Word& word, std::uint32_t line) {
    if (!is_told(word.text)) return;
    const Read read = read_of(word.text, line);
    const Token* const token = token_at(program_, line, read.begin);
    ASSERT_NE(token, nullptr) << shown(program_, read);
    EXPECT_TRUE(ends_a_token(program_, read)) << shown(program_, read);
    if (word.has(gcode::WordFlag::literal) && !word.has(gcode::WordFlag::comma)) {
      EXPECT_EQ(kinds_within(program_, read), std::set{kind_of(word.letter)})
          << shown(program_, read);
    }
    ++count_;
  }

  static TokenKind kind_of(char letter) {
    if (letter == 'G') return TokenKind::command;
    if (letter == 'M') return TokenKind::switching;
    if (letter == 'N') return TokenKind::sequence;
    if (letter == 'O') return TokenKind::program;
    return std::string_view("FSTHDPLE").find(letter) != std::string_view::npos
               ? TokenKind::technology
               : TokenKind::dimension;
  }

  void expect_one_token(const Read& read) {
    const Token* const token = token_at(program_, read.line, read.begin);
    ASSERT_NE(token, nullptr) << shown(program_, read);
    EXPECT_EQ(token->begin + token->length, read.end) << shown(program_, read);
    EXPECT_NE(token->kind, TokenKind::error) << shown(program_, read);
    ++count_;
  }

  const CutProgram& program_;
  base::SourceSet sources_;
  base::FileId file_{};
  std::size_t count_ = 0;
};

TEST(Tokens, AreWhatTheCompilersRead) {
  std::size_t count = 0;
  for (const CutProgram& program : all_programs()) count += Agreement(program).check();
  EXPECT_GT(count, 20'000U);
}

TEST(Tokens, OfAListingAreWhatItsReaderReads) {
  const DialectRow& pattern = *machine::find_dialect("pattern");
  for (const std::string line :
       {"F T2 4000", " S 1 -2 +3 # cut", "# nothing", "", "F T4 1", "S 1 2", "G01 X1", "S 1 2 x"}) {
    const auto tokens = base::tokens_of(*pattern.language, line);
    const bool is_wrong = std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
      return token.kind == TokenKind::error;
    });
    // What is missing is in no token.
    if (line != "S 1 2") {
      EXPECT_EQ(is_wrong, !drive::parse_listing(line, {})) << line;
    }
  }
}

// Any line at all, so that half of what can be typed is wrong.
std::string random_line(std::mt19937& random) {
  static const std::vector<std::string> kPieces = {"G",      "01",   "X",
                                                   "#",      "[",    "]",
                                                   "(",      ")",    ";",
                                                   "%",      "O",    "N",
                                                   "/",      "<",    ">",
                                                   ":",      "&",    "GOTO",
                                                   "IF",     "EQ",   "SIN",
                                                   "DPRNT",  "=",    "-",
                                                   " ",      "\t",   ".",
                                                   "1",      ",",    "\"",
                                                   "'",      "*",    "REM ",
                                                   "move",   "\r",   "\x7f",
                                                   "\xC3",   "\xA9", "\xEF\xBC\xA1",
                                                   "POINT",  "END",  "F",
                                                   "S",      "T1",   "SETVN",
                                                   "_ABSMT", "\0",   "^"};
  std::string line;
  for (int count = std::uniform_int_distribution(0, 20)(random); count > 0; --count)
    line += kPieces[std::uniform_int_distribution<std::size_t>(0, kPieces.size() - 1)(random)];
  return line;
}

TEST(Tokens, OfAnyLineHoldEachByteOnce) {
  constexpr unsigned kSeed = 70;
  std::mt19937 random(kSeed);
  for (int i = 0; i < 50'000; ++i) {
    const std::string line = random_line(random);
    for (const DialectRow& row : machine::dialects()) {
      std::size_t at = 0;
      for (const Token& token : base::tokens_of(*row.language, line)) {
        ASSERT_EQ(token.begin, at) << row.name << ": " << line << ", seed " << kSeed;
        ASSERT_GT(token.length, 0U) << row.name << ": " << line;
        at += token.length;
      }
      ASSERT_EQ(at, line.size()) << row.name << ": " << line << ", seed " << kSeed;
    }
  }
}

// What a client may send at once takes no longer than in proportion to its length.
TEST(Tokens, OfALongLineTakeTimeInProportion) {
  const auto seconds = [](const base::Language& language, const std::string& piece) {
    std::string line;
    while (line.size() < (1U << 16)) line += piece;
    const auto began = std::chrono::steady_clock::now();
    static_cast<void>(base::tokens_of(language, line));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  for (const DialectRow& row : machine::dialects()) {
    for (const char* const piece : {"<", "O ", "O<", "#[", "(", "1 ", "1.", "X1 ", "\"", ", ", "["})
      EXPECT_LT(seconds(*row.language, piece), 1) << row.name << ": " << piece;
  }
}

std::string manual(const std::string& name) {
  std::ifstream file(std::string(KERF_MANUAL) + "/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Languages, KeyWordsAreInTheirManuals) {
  const std::vector<std::pair<std::string, std::string>> manuals = {
      {"fanuc-mill", "macro-language.md"},
      {"laser-basic", "laser-basic.md"},
      {"teach", "teach.md"},
      {"motion", "motions.md"},
      {"pattern", "pattern.md"}};
  for (const auto& [dialect, page] : manuals) {
    const std::string text = manual(page);
    for (const std::string_view word : machine::find_dialect(dialect)->language->key_words)
      EXPECT_NE(text.find(word), std::string::npos) << page << " does not name " << word;
  }
}

TEST(Languages, ExamplesAndNewProgramsAreInThem) {
  for (const DialectRow& row : machine::dialects()) {
    for (const Token& token : base::tokens_of(*row.language, row.language->example))
      EXPECT_NE(token.kind, TokenKind::error) << row.name;
    std::istringstream fresh{std::string(row.language->fresh)};
    for (std::string line; std::getline(fresh, line);) {
      for (const Token& token : base::tokens_of(*row.language, line))
        EXPECT_NE(token.kind, TokenKind::error) << row.name;
    }
  }
}

TEST(Dialects, AreThoseOfMachineFiles) {
  for (const DialectRow& row : machine::dialects()) {
    EXPECT_NE(std::find(machine::kDialects.begin(), machine::kDialects.end(), row.name),
              machine::kDialects.end())
        << row.name;
    EXPECT_TRUE(machine::find_machine(std::string(row.machine))) << row.machine;
  }
}

TEST(Dialects, ShowByEndingThenByTheFirstLineThatSaysSomething) {
  const auto shown = [](const std::string& name, const std::string& text) {
    return machine::dialect_shown_by(*base::SourceFile::from_text(name, text));
  };
  EXPECT_EQ(shown("a.BAS", "G01 X1.\n"), "laser-basic");
  EXPECT_EQ(shown("a.tch", ""), "teach");
  EXPECT_EQ(shown("a.pat", ""), "pattern");
  EXPECT_EQ(shown("a.jsonl", "G01 X1.\n"), "motion");
  EXPECT_EQ(shown("a.nc", "\n {\"kind\":\"end\"}\n"), "motion");
  EXPECT_EQ(shown("a.nc", "\n  teach 1\n"), "teach");
  EXPECT_EQ(shown("a.nc", "r = 2\n"), "laser-basic");
  EXPECT_EQ(shown("a.nc", "%\nmove(1, 2)\n"), "");
  EXPECT_EQ(shown("a", "O1\nprint 1\n"), "");
}

}  // namespace
}  // namespace kerf::test
