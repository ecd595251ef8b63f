// Pages that are compiled beside whoever executes them are those that he would have compiled
// himself, in whatever order he asks for them.
#include <gtest/gtest.h>

#include <random>

#include "lang/gcode/code_library.hpp"

namespace kerf::gcode {
namespace {

constexpr std::uint32_t kLinesPerPage = 4;

std::string long_program(std::uint32_t lines) {
  std::string text = "O1\n";
  for (std::uint32_t line = 1; line < lines; ++line) {
    text += "N" + std::to_string(line) + " G01 X" + std::to_string(line) + ".";
    if (line % 7 == 0) text += " Z[#" + std::to_string(100 + line % 50) + "+1.]";
    text += line % 11 == 0 ? " (a comment)\n" : "\n";
  }
  return text;
}

// A library of one program.
struct Library {
  explicit Library(const std::string& text, std::size_t fresh_pages = 8)
      : code(sources, {.lines_per_page = kLinesPerPage, .fresh_pages = fresh_pages}) {
    code.add_file(sources.add(base::SourceFile::from_text("program", text)));
  }
  GcodePage& page(std::uint32_t number) { return code.page(vm::CodeId{0}, number); }

  base::SourceSet sources;
  CodeLibrary code;
};

std::string story_of(const GcodePage& page) {
  std::string story = "page " + std::to_string(page.number) + " of " +
                      std::to_string(static_cast<int>(page.file)) + " from " +
                      std::to_string(page.text_begin) + " to " + std::to_string(page.text_end) +
                      " line " + std::to_string(page.next_line) + (page.last ? " last" : "");
  for (const vm::Instruction& i : page.instructions) {
    for (const auto number : {static_cast<std::uint32_t>(i.op), std::uint32_t{i.a},
                              std::uint32_t{i.b}, std::uint32_t{i.c}, i.n})
      story += " " + std::to_string(number);
  }
  for (const Word& word : page.words)
    story += " " + std::string(1, word.letter) + std::to_string(word.value);
  for (const vm::BlockMark& mark : page.marks)
    story += " " + std::to_string(mark.line) + ":" + std::to_string(mark.offset);
  for (const base::Diagnostic& failure : page.failures)
    story += " " + failure.number + " " + failure.message;
  return story;
}

// The pages as the compiler makes them one after the other.
std::vector<std::string> pages_of(const std::string& text) {
  const auto file = base::SourceFile::from_text("program", text);
  const ProgramEntry entry = read_directory(*file, base::FileId{0}).programs.front();
  PageCompiler compiler(kLinesPerPage);
  NameTable names;
  GcodePage page;
  PageStart start{entry.begin, entry.line, entry.line_start};
  std::vector<std::string> pages;
  do {
    page.number = static_cast<std::uint32_t>(pages.size());
    compiler.compile(*file, base::FileId{0}, start, entry.end, names, page);
    start = {page.text_end, page.next_line, page.text_end};
    pages.push_back(story_of(page));
  } while (!page.last);
  return pages;
}

void expect_straight(const std::string& text) {
  const std::vector<std::string> wanted = pages_of(text);
  Library library(text);
  for (std::uint32_t number = 0; number < wanted.size(); ++number)
    ASSERT_EQ(story_of(library.page(number)), wanted[number]);
}

TEST(PagesAhead, AreThoseOfAProgramThatRunsStraightOn) { expect_straight(long_program(600)); }

TEST(PagesAhead, EndWithTheProgram) {
  for (std::uint32_t lines = 30; lines < 60; ++lines) expect_straight(long_program(lines));
  expect_straight(long_program(200) + "M30\nO2\nG00 X1.\n");
}

TEST(PagesAhead, KeepTheNumbersOfNames) {
  std::string text = long_program(100);
  for (int i = 0; i < 100; ++i)
    text += "#<n" + std::to_string(i % 9) + ">=" + std::to_string(i) + "\n";
  text += long_program(100).substr(3);
  expect_straight(text);
}

TEST(PagesAhead, TellWhatIsWrongWhereItStands) {
  std::string text = long_program(90);
  text += "G01 X1.2.3\nIF[#1\nX\n";
  text += long_program(90).substr(3);
  expect_straight(text);
}

TEST(PagesAhead, AreGivenUpWhereAProgramJumps) {
  const std::string text = long_program(2000);
  const std::vector<std::string> wanted = pages_of(long_program(2000));
  Library library(text, 2);
  std::mt19937 random(1);
  for (int jump = 0; jump < 200; ++jump) {
    auto number = static_cast<std::uint32_t>(random() % wanted.size());
    const auto run = static_cast<std::uint32_t>(random() % 40);
    for (std::uint32_t i = 0; i < run && number < wanted.size(); ++i, ++number)
      ASSERT_EQ(story_of(library.page(number)), wanted[number]);
  }
}

TEST(PagesAhead, OfAProgramThatNobodyFinishes) {
  const std::string text = long_program(4000);
  for (std::uint32_t pages = 0; pages < 60; ++pages) {
    Library library(text);
    for (std::uint32_t number = 0; number < pages; ++number) library.page(number);
  }
}

}  // namespace
}  // namespace kerf::gcode
