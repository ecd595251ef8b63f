#include "output/programs/unified_diff.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <vector>

namespace kerf::output {
namespace {

using Stretches = std::vector<base::TextStretch>;

std::string numbered(int count, const std::string& end = "\n") {
  std::string text;
  for (int i = 1; i <= count; ++i) text += "N" + std::to_string(i) + end;
  return text;
}

// What stands at a line, from 1, of such a text.
base::TextStretch at_line(const std::string& text, int line, const std::string& instead) {
  const std::string number = "N" + std::to_string(line);
  return {text.find(number), number.size(), instead};
}

TEST(UnifiedDiff, HasThreeLinesOfContext) {
  const std::string text = numbered(20);
  EXPECT_EQ(unified_diff("part.nc", text, Stretches{at_line(text, 10, "X10")}),
            "--- a/part.nc\n+++ b/part.nc\n@@ -7,7 +7,7 @@\n N7\n N8\n N9\n-N10\n+X10\n N11\n "
            "N12\n N13\n");
}

TEST(UnifiedDiff, MeetsBothEnds) {
  const std::string text = numbered(3);
  const Stretches stretches{{0, 0, "N0\n"}, {text.size(), 0, "N4\n"}};
  EXPECT_EQ(unified_diff("p", text, stretches),
            "--- a/p\n+++ b/p\n@@ -1,3 +1,5 @@\n+N0\n N1\n N2\n N3\n+N4\n");
}

TEST(UnifiedDiff, BeginsAnewWhereContextsAreApart) {
  const std::string text = numbered(30);
  const Stretches near{at_line(text, 5, "A5"), at_line(text, 12, "A12")};
  const std::string one = unified_diff("p", text, near);
  EXPECT_NE(one.find("@@ -2,14 +2,14 @@\n"), std::string::npos) << one;
  const Stretches far{at_line(text, 5, "A5\nB5"), at_line(text, 13, "A13")};
  const std::string two = unified_diff("p", text, far);
  EXPECT_NE(two.find("@@ -2,7 +2,8 @@\n"), std::string::npos) << two;
  EXPECT_NE(two.find("@@ -10,7 +11,7 @@\n"), std::string::npos) << two;
}

TEST(UnifiedDiff, TellsThatAnEndIsMissing) {
  EXPECT_EQ(unified_diff("p", "A\nM30", Stretches{{5, 0, "\nX1"}}),
            "--- a/p\n+++ b/p\n@@ -1,2 +1,3 @@\n A\n-M30\n\\ No newline at end of file\n"
            "+M30\n+X1\n\\ No newline at end of file\n");
  EXPECT_EQ(unified_diff("/p", "A\nM30", Stretches{{0, 1, "B"}}),
            unified_diff("p", "A\nM30", Stretches{{0, 1, "B"}}));
  EXPECT_EQ(unified_diff("p", "A\nM30", Stretches{{0, 1, "B"}}),
            "--- a/p\n+++ b/p\n@@ -1,2 +1,2 @@\n-A\n+B\n M30\n\\ No newline at end of file\n");
}

TEST(UnifiedDiff, KeepsCarriageReturns) {
  const std::string text = numbered(2, "\r\n");
  EXPECT_EQ(unified_diff("p", text, Stretches{at_line(text, 2, "X2")}),
            "--- a/p\n+++ b/p\n@@ -1,2 +1,2 @@\n N1\r\n-N2\r\n+X2\r\n");
}

TEST(UnifiedDiff, JoinsLinesWhoseEndIsTaken) {
  EXPECT_EQ(unified_diff("p", "A\nB\nC\n", Stretches{{1, 1, ""}}),
            "--- a/p\n+++ b/p\n@@ -1,3 +1,2 @@\n-A\n-B\n+AB\n C\n");
  EXPECT_EQ(unified_diff("p", "A\nB\nC\n", Stretches{{2, 2, ""}}),
            "--- a/p\n+++ b/p\n@@ -1,3 +1,2 @@\n A\n-B\n C\n");
}

TEST(UnifiedDiff, IsEmptyWhereNothingChanges) {
  EXPECT_EQ(unified_diff("p", "A\nB\n", Stretches{}), "");
  EXPECT_EQ(unified_diff("p", "A\nB\n", Stretches{{0, 1, "A"}}), "");
  EXPECT_EQ(unified_diff("p", "", Stretches{}), "");
}

TEST(UnifiedDiff, GoesFromAndToNothing) {
  EXPECT_EQ(unified_diff("p", "", Stretches{{0, 0, "A\n"}}),
            "--- a/p\n+++ b/p\n@@ -0,0 +1 @@\n+A\n");
  EXPECT_EQ(unified_diff("p", "A\n", Stretches{{0, 2, ""}}),
            "--- a/p\n+++ b/p\n@@ -1 +0,0 @@\n-A\n");
}

TEST(UnifiedDiff, QuotesNamesThatWouldBreakTheHead) {
  const auto head = [](const std::string& name) {
    return unified_diff(name, "A\n", Stretches{{0, 1, "B"}}).substr(0, name.size() + 20);
  };
  EXPECT_EQ(head("my part.nc").substr(0, 17), "--- a/my part.nc\t");
  EXPECT_EQ(head("a\n\"b").substr(0, 17), "--- \"a/a\\012\\\"b\"\n");
}

// A diff that is applied word by word: what comes out, or where it does not fit.
std::string applied(const std::string& before, const std::string& diff) {
  std::vector<std::string> old_lines;
  const auto lines = [](const std::string& text) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
      all.push_back(text.substr(at, end - at));
      at = end;
    }
    return all;
  };
  old_lines = lines(before);
  std::string after;
  std::size_t next = 0;
  for (const std::string& line : lines(diff)) {
    if (line.starts_with("--- ") || line.starts_with("+++ ")) continue;
    if (line.starts_with("\\")) continue;
    if (line.starts_with("@@")) {
      const std::size_t first = std::stoul(line.substr(4));
      const bool none = line.substr(4, line.find(' ', 4) - 4).ends_with(",0");
      while (next + 1 < first + (none ? 1 : 0)) after += old_lines.at(next++);
      continue;
    }
    const std::string text = line.substr(1);
    if (line[0] == '+') {
      after += text;
      continue;
    }
    const std::string& old = old_lines.at(next++);
    if (old != text && old + "\n" != text) return "does not fit at line " + std::to_string(next);
    if (line[0] == ' ') after += old;
  }
  while (next < old_lines.size()) after += old_lines.at(next++);
  return after;
}

TEST(UnifiedDiff, LeadsFromTextToText) {
  std::mt19937 random(7);
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    const int size = static_cast<int>(random() % 60);
    for (int i = 0; i < size; ++i) text += "AB\n"[random() % 3];
    text += '\n';
    Stretches stretches;
    std::string after;
    std::size_t at = 0;
    while (at < text.size() && random() % 4 != 0) {
      const std::size_t begin = at + random() % (text.size() - at);
      const std::size_t length = random() % std::min<std::size_t>(4, text.size() - begin);
      std::string instead;
      for (std::uint32_t i = random() % 4; i > 0; --i) instead += "CD\n"[random() % 3];
      after += text.substr(at, begin - at) + instead;
      stretches.push_back({begin, length, instead});
      at = begin + length;
    }
    after += text.substr(at);
    if (!after.ends_with('\n')) continue;
    ASSERT_EQ(applied(text, unified_diff("p", text, stretches)), after) << round << "\n" << text;
  }
}

TEST(UnifiedDiff, TakesTimeByTheLengthOfTheText) {
  const std::string text = numbered(200'000);
  Stretches stretches;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at + 20) + 1)
    stretches.push_back({at, 1, "G1 N"});
  const auto begin = std::chrono::steady_clock::now();
  const std::string diff = unified_diff("p", text, stretches);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  EXPECT_GT(diff.size(), text.size());
  EXPECT_LT(taken.count(), 5.0);
}

}  // namespace
}  // namespace kerf::output
