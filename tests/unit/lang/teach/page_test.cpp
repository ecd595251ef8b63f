#include <gtest/gtest.h>

#include "lang/teach/teach_library.hpp"
#include "taught_text.hpp"

namespace kerf::test {
namespace {

// Blocks and alarms of a file as the virtual machine meets them: "LINE@3", "TEACH_COUNT 4:1+4".
std::vector<std::string> listing(const std::string& text, std::uint32_t lines_per_page) {
  base::SourceSet sources;
  const base::FileId file = sources.add(base::SourceFile::from_text("test.tch", text));
  teach::TeachLibrary library(sources, {.lines_per_page = lines_per_page, .fresh_pages = 2});
  library.load(file);
  std::vector<std::string> list;
  for (std::uint32_t number = 0;; ++number) {
    const teach::TeachPage& page = library.page(teach::TeachLibrary::kProgram, number);
    for (std::uint32_t at = 0; at < page.instructions.size(); ++at) {
      const vm::Instruction instruction = page.instructions[at];
      const base::Place place = page.place_of(at);
      if (instruction.op == vm::Op::do_block) {
        std::string record;
        teach::append_record(record, page.blocks[instruction.n].record);
        list.push_back(record + "@" + std::to_string(place.line) + ":" +
                       std::to_string(place.column) + "+" + std::to_string(place.length));
      } else if (instruction.op == vm::Op::fail) {
        list.push_back(told(page.failures[instruction.n]));
        EXPECT_EQ(page.failures[instruction.n].place.line, place.line);
        EXPECT_EQ(page.failures[instruction.n].place.line_start, place.line_start);
      }
    }
    if (page.last) return list;
  }
}

TEST(TeachPage, RecordsAreBlocksAndMistakesAlarms) {
  EXPECT_EQ(listing("TEACH 1\n\n  FEED 9 ;c\nLINE 1\nEND\n", 256),
            (std::vector<std::string>{"TEACH 1@1:1+5", "FEED 9@3:3+4", "TEACH_COUNT 4:1+4",
                                      "END@5:1+3"}));
}

TEST(TeachPage, EndIsExecutedOnlyIfNothingFollows) {
  EXPECT_EQ(listing("TEACH 1\nEND\n;\n\nLINE 1\nx\n", 256),
            (std::vector<std::string>{"TEACH 1@1:1+5", "TEACH_ORDER 5:1+4"}));
  EXPECT_EQ(listing("TEACH 1\n", 256),
            (std::vector<std::string>{"TEACH 1@1:1+5", "TEACH_ORDER 1:1+0"}));
}

TEST(TeachPage, CodeIsTheSameHoweverItIsCutIntoPages) {
  std::string text = "TEACH 1\r\nFEED 100\nPOINT 0 0 0 0 0\n";
  for (int i = 1; i < 300; ++i)
    text += "  LINE " + std::to_string(i) + " 0 0 0 0 ; n\n" + (i % 7 == 0 ? "\nLINE\n" : "") +
            (i % 11 == 0 ? "ARC 1 2 3 4 5 1 2 3 4 5\n" : "");
  text += "END\n\n\n;c\nlater\n";
  const auto whole = listing(text, 100'000);
  EXPECT_GT(whole.size(), 300U);
  for (const std::uint32_t lines : {1U, 2U, 3U, 7U, 64U}) EXPECT_EQ(listing(text, lines), whole);
}

TEST(TeachPage, PagesMayBeAskedForAgainInAnyOrder) {
  base::SourceSet sources;
  std::string text = "TEACH 1\n";
  for (int i = 0; i < 50; ++i) text += "DWELL " + std::to_string(i) + "\n";
  const base::FileId file = sources.add(base::SourceFile::from_text("test.tch", text + "END\n"));
  teach::TeachLibrary library(sources, {.lines_per_page = 1, .fresh_pages = 2});
  library.load(file);
  const auto dwell = [&](std::uint32_t page) {
    const auto& block = library.page(teach::TeachLibrary::kProgram, page).blocks.front();
    return std::get<teach::Dwell>(block.record).seconds;
  };
  for (const std::uint32_t page : {40U, 41U, 40U, 3U, 50U, 4U}) EXPECT_EQ(dwell(page), page - 1);
}

TEST(TeachPage, CheckFindsEveryMistake) {
  base::SourceSet sources;
  const base::FileId file = sources.add(
      base::SourceFile::from_text("test.tch", "TEACH 1\nLINE 1\nx\nLASER MAYBE\nEND\nEND\n"));
  teach::TeachLibrary library(sources, {.lines_per_page = 2});
  library.load(file);
  std::vector<std::string> found;
  base::Findings findings;
  library.check("test", findings);
  for (const base::Diagnostic& mistake : findings.list()) found.push_back(told(mistake));
  EXPECT_EQ(found, (std::vector<std::string>{"TEACH_COUNT 2:1+4", "TEACH_RECORD 3:1+1",
                                             "TEACH_RECORD 4:7+5", "TEACH_ORDER 6:1+3"}));
}

}  // namespace
}  // namespace kerf::test
