#include "output/reports/line_runs.hpp"

#include <gtest/gtest.h>

namespace kerf::output {
namespace {

constexpr base::FileId kFile{0};

bool every_line(base::FileId, std::uint32_t) { return true; }

TEST(LineRuns, CountsEachLineOfEachFileForItself) {
  LineRuns runs;
  for (int i = 0; i < 3; ++i) runs.count(kFile, 7);
  runs.count(base::FileId{1}, 7);
  EXPECT_EQ(runs.of(kFile, 7), 3U);
  EXPECT_EQ(runs.of(base::FileId{1}, 7), 1U);
  EXPECT_EQ(runs.of(kFile, 8), 0U);
}

TEST(LineRuns, ForgetsIdleLinesButNotThoseThatRanLast) {
  LineRuns runs;
  constexpr std::uint32_t kLines = 250'000;
  for (std::uint32_t line = 1; line <= kLines; ++line) runs.count(kFile, line);
  runs.forget([](base::FileId, std::uint32_t line) { return line != 5; });
  EXPECT_EQ(runs.size(), LineRuns::kAhead + 1);
  EXPECT_EQ(runs.of(kFile, 5), 1U) << "it has done something";
  EXPECT_EQ(runs.of(kFile, kLines - LineRuns::kAhead), 0U);
  EXPECT_EQ(runs.of(kFile, kLines - LineRuns::kAhead + 1), 1U);
}

TEST(LineRuns, KeepsALineThatRunsAgainAndAgain) {
  LineRuns runs;
  for (std::uint32_t line = 1; line <= LineRuns::kAhead; ++line) runs.count(kFile, line);
  for (int i = 0; i < 2; ++i) runs.count(kFile, 1);
  runs.forget(every_line);
  EXPECT_EQ(runs.of(kFile, 1), 3U);
  EXPECT_EQ(runs.of(kFile, 2), 0U);
  EXPECT_EQ(runs.of(kFile, 3), 1U);
}

}  // namespace
}  // namespace kerf::output
