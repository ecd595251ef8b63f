// Every block knows its line and column, whatever ends the lines, however long they are, and
// wherever the text is cut into pages and chunks.
#include <gtest/gtest.h>

#include <random>

#include "base/text_window.hpp"
#include "lang/gcode/code_library.hpp"

namespace kerf::gcode {
namespace {

/// A block as the compiled program tells it.
struct Told {
  std::uint32_t line = 0;
  std::uint64_t offset = 0;      // of the block in the file
  std::uint64_t line_start = 0;  // of its line
};

std::vector<Told> blocks_of(const std::string& text, std::uint32_t lines_per_page) {
  base::SourceSet sources;
  const base::FileId file = sources.add(base::SourceFile::from_text("part.nc", text));
  CodeLibrary library(sources, {.lines_per_page = lines_per_page});
  library.add_file(file);
  std::vector<Told> told;
  for (std::size_t program = 0; program < library.program_count(); ++program) {
    for (std::uint32_t number = 0;; ++number) {
      const GcodePage& page = library.page(vm::CodeId(static_cast<std::uint32_t>(program)), number);
      for (const vm::BlockMark& mark : page.marks) {
        told.push_back(
            {mark.line, page.text_begin + mark.offset, page.text_begin + mark.line_offset});
      }
      if (page.last) break;
    }
  }
  return told;
}

// A text of blocks "#1=n" put together with its own account of where they stand.
struct Text {
  std::string text;
  std::vector<Told> blocks;
  std::uint32_t line = 1;
  std::uint64_t line_start = 0;

  void end_line(const std::string& end) {
    text += end;
    ++line;
    line_start = text.size();
  }
};

Text random_text(std::mt19937& random, const std::vector<std::string>& ends, int lines) {
  Text result;
  for (int i = 0; i < lines; ++i) {
    if (random() % 5 != 0) {
      result.blocks.push_back({result.line, result.line_start, result.line_start});
      result.text += std::string(random() % 3, ' ') + "#1=" + std::to_string(random() % 1000);
    }
    result.end_line(ends[random() % ends.size()]);
  }
  return result;
}

TEST(LineNumbers, AreThoseOfTheTextForEveryPageSizeAndLineEnd) {
  constexpr unsigned kSeed = 20260101;
  std::mt19937 random(kSeed);
  // A lone CR before an LF would be a CR LF, and an LF before a CR a pair: only ends that can stand
  // beside each other.
  const std::vector<std::vector<std::string>> families = {
      {"\n"}, {"\r\n"}, {"\r"}, {"\r\r\n"}, {"\n", "\r\n"}};
  for (const auto& ends : families) {
    for (int run = 0; run < 20; ++run) {
      const Text text = random_text(random, ends, 300);
      for (const std::uint32_t size : {1U, 2U, 7U, 256U}) {
        const std::vector<Told> told = blocks_of(text.text, size);
        ASSERT_EQ(told.size(), text.blocks.size()) << size << " lines a page";
        for (std::size_t i = 0; i < told.size(); ++i) {
          ASSERT_EQ(told[i].line, text.blocks[i].line)
              << "block " << i << " with " << size << " lines a page and lines that end in "
              << testing::PrintToString(ends) << ", seed " << kSeed << ", run " << run;
          ASSERT_EQ(told[i].line_start, text.blocks[i].line_start) << "block " << i;
        }
      }
    }
  }
}

TEST(LineNumbers, AnLfCrPairIsOneLineEndWhereverTheTextIsCut) {
  std::string text;
  constexpr int kLines = 8000;  // more than is read at once
  for (int i = 0; i < kLines; ++i) text += "#1=1234\n\r";
  for (const std::uint32_t size : {1U, 2U, 7U, 256U, 100'000U}) {
    const std::vector<Told> told = blocks_of(text, size);
    ASSERT_EQ(told.size(), static_cast<std::size_t>(kLines));
    EXPECT_EQ(told.back().line, static_cast<std::uint32_t>(kLines)) << size << " lines a page";
  }
}

TEST(LineNumbers, BlocksOfOneLineAreToldApartByTheirColumn) {
  const std::string text = "#1=1; #2=2 ;;(A;B) #3=3\n;#4=4\n";
  for (const std::uint32_t size : {1U, 2U}) {
    const std::vector<Told> told = blocks_of(text, size);
    ASSERT_EQ(told.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(told[i].line, i < 3 ? 1U : 2U);
      const std::string wanted = "#" + std::to_string(i + 1);
      const std::string behind = text.substr(told[i].offset);
      EXPECT_LT(behind.find(wanted), 10U) << "block " << i << " begins at " << behind;
    }
  }
}

// A line that is too long, with its end at every place of what is read at once.
TEST(LineNumbers, BehindALineThatIsTooLongAreRightHoweverItEnds) {
  constexpr std::size_t kChunk = 1 << 15;
  for (const std::string end : {"\n", "\r\n", "\r", "\r\r\n"}) {
    for (int shift = -6; shift <= 6; ++shift) {
      for (const std::size_t chunks : {0U, 1U, 2U}) {
        const std::size_t length =
            base::kLongestBlock + (chunks + 1) * kChunk + static_cast<std::size_t>(shift + 6);
        const std::string text =
            "#1=1" + end + "(" + std::string(length, 'c') + end + "#1=2" + end + "#1=3" + end;
        const std::vector<Told> told = blocks_of(text, 256);
        ASSERT_EQ(told.size(), 4U);  // the long line counts as a block that alarms
        const std::string what = "behind " + std::to_string(length + 1) + " characters and " +
                                 testing::PrintToString(end);
        ASSERT_EQ(told[1].line, 2U) << what;
        ASSERT_EQ(told[2].line, 3U) << what;
        ASSERT_EQ(told[3].line, 4U) << what;
        ASSERT_EQ(text.substr(told[3].offset, 4), "#1=3") << what;
      }
    }
  }
}

TEST(LineNumbers, TheLongestLineThatIsAllowedIsABlock) {
  for (const std::size_t length :
       {base::kLongestBlock - 1, base::kLongestBlock, base::kLongestBlock + 1}) {
    base::SourceSet sources;
    std::string line = "#1=1 (";
    line.resize(length, 'c');
    const std::string text = line + "\nM30\n";
    const auto file = sources.add(base::SourceFile::from_text("part.nc", text));
    CodeLibrary library(sources);
    library.add_file(file);
    const GcodePage& page = library.page(vm::CodeId{0}, 0);
    EXPECT_EQ(page.failures.size(), length > base::kLongestBlock ? 1U : 0U)
        << length << " characters";
    EXPECT_EQ(blocks_of(text, 256).size(), 2U);
  }
}

}  // namespace
}  // namespace kerf::gcode
