#include "job/motion_lines.hpp"

#include <gtest/gtest.h>

#include <string>

namespace kerf::job {
namespace {

base::BlockId block_of(std::uint32_t file, std::uint32_t line, std::uint32_t program = 1,
                       std::uint32_t calls = 0) {
  base::BlockId block;
  block.file = base::FileId{file};
  block.line = line;
  block.program = base::ProgramNumber{program};
  block.calls = base::CallPath{calls};
  return block;
}

TEST(MotionLines, KnowLineFileProgramAndCallsOfEveryMotion) {
  MotionLines lines;
  std::vector<base::BlockId> told;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const bool is_sub = i % 10 >= 7;
    told.push_back(block_of(is_sub ? 1 : 0, i % 97 + 1, is_sub ? 7 : 1, is_sub ? i / 10 : 0));
    lines.add(told.back());
  }
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(lines.block(i + 1), told[i]) << i;
  EXPECT_EQ(lines.block(0), base::BlockId{});
  EXPECT_EQ(lines.block(told.size() + 1), base::BlockId{});
}

TEST(MotionLines, TakeFourBytesAMotionAndSixteenAChange) {
  MotionLines lines;
  for (std::uint32_t i = 0; i < 5000; ++i) lines.add(block_of(0, i));
  EXPECT_EQ(lines.bytes(), 5000U * 4 + 16);
  lines.add(block_of(1, 1));
  lines.add(block_of(0, 1));
  EXPECT_EQ(lines.bytes(), 5002U * 4 + 3 * 16);
}

TEST(MotionLines, StartsOfLinesAreFoundInAnyOrderWhateverEndsThem) {
  base::SourceSet sources;
  const std::string text = "O1\r\nG00\n\nX1\n" + std::string(200'000, ' ') + "Y2\nZ3";
  const base::FileId one = sources.add(base::SourceFile::from_text("one.nc", text));
  const base::FileId other = sources.add(base::SourceFile::from_text("other.nc", "O2\nM99\n"));
  const auto in = [](base::FileId file, std::uint32_t line) {
    return block_of(static_cast<std::uint32_t>(file), line);
  };
  std::vector<base::BlockId> blocks{in(one, 6), in(other, 2), in(one, 2),
                                    in(one, 4), in(one, 2),   block_of(0xffffffffU, 0),
                                    in(one, 1), in(other, 1)};
  find_line_starts(sources, blocks);
  const std::vector<std::uint64_t> wanted{text.find("Z3"), 3, 4, text.find("X1"), 4, 0, 0, 0};
  for (std::size_t i = 0; i < blocks.size(); ++i) EXPECT_EQ(blocks[i].from, wanted[i]) << i;
}

}  // namespace
}  // namespace kerf::job
