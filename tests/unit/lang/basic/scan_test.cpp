#include "lang/basic/scan.hpp"

#include <gtest/gtest.h>

namespace kerf::basic {
namespace {

Scan scan_of(const std::string& text, std::uint32_t lines_per_page = 256) {
  base::SourceSet sources;
  const base::FileId file = sources.add(base::SourceFile::from_text("test.bas", text));
  return scan(sources[file], file, lines_per_page);
}

std::string findings(const Scan& scan) {
  std::string text;
  for (const base::Diagnostic& finding : scan.findings)
    text += finding.number + " " + std::to_string(finding.place.line) + ":" +
            std::to_string(finding.place.column) + "; ";
  return text;
}

TEST(BasicScan, FindsLabelsAtTheBeginningOfLinesOnly) {
  const Scan scan = scan_of("a: x=1\n100 y=2\n  b : z=3; c: q=4\nx=100\n");
  EXPECT_EQ(scan.labels.size(), 3U);
  EXPECT_EQ(scan.labels.at("A").line, 1U);
  EXPECT_EQ(scan.labels.at("100").line, 2U);
  EXPECT_EQ(scan.labels.at("B").line, 3U);
  EXPECT_EQ(findings(scan), "");
}

TEST(BasicScan, ALabelIsNoVariableButForItsName) {
  const Scan scan = scan_of("a: goto a\nb: gosub c\nc: b=1\n");
  EXPECT_EQ(scan.variable_names, (std::vector<std::string>{"B"}));
}

TEST(BasicScan, VariablesOfLoopsComeFirst) {
  const Scan scan = scan_of("x=1;y=2\nfor k=x to y\nfor y=1 to 2\nnext\nnext\n");
  EXPECT_EQ(scan.variable_names, (std::vector<std::string>{"K", "Y", "X"}));
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(scan.variables.at(scan.variable_names[i]), i);
}

TEST(BasicScan, EveryForKnowsTheNextThatStandsBehindIt) {
  const Scan scan = scan_of("for a=1 to 2\nfor b=1 to 2;next\nfor c=1 to 2\nnext;next\n");
  EXPECT_EQ(scan.next_of_loop, (std::vector<std::uint32_t>{2, 0, 1}));
  EXPECT_EQ(scan.nexts, 3U);
}

TEST(BasicScan, TellsAllMistakesOfReadingInTheOrderOfTheText) {
  EXPECT_EQ(findings(scan_of("for i=1 to 2\nx=1a;y=$\na: b=\"q\na: c=1\n")),
            "LB0014 1:1; LB0021 2:3; LB0026 2:8; LB0020 3:6; LB0007 4:1; ");
}

TEST(BasicScan, ANextBeforeItsForDoesNotCloseIt) {
  EXPECT_EQ(findings(scan_of("next\nfor i=1 to 2\n")), "LB0014 2:1; ");
  EXPECT_EQ(findings(scan_of("x=1 'for\nrem for\nprint \"for\"\n")), "");
}

TEST(BasicScan, APageKnowsHowManyLoopsAreBeforeIt) {
  const Scan scan = scan_of("for i=1 to 2\nfor j=1 to 2\nnext\nnext\nx=1\n", 2);
  ASSERT_EQ(scan.pages.size(), 3U);
  EXPECT_EQ(scan.pages[1].line, 3U);
  EXPECT_EQ(scan.pages[1].offset, 26U);
  EXPECT_EQ(scan.pages[1].loops, 2U);
  EXPECT_EQ(scan.pages[1].nexts, 0U);
  EXPECT_EQ(scan.pages[2].nexts, 2U);
}

TEST(BasicScan, AnEmptyTextIsAPage) {
  EXPECT_EQ(scan_of("").pages.size(), 1U);
  EXPECT_EQ(findings(scan_of("")), "");
}

TEST(BasicScan, NumbersAreTheSameLabelHoweverTheyAreWritten) {
  EXPECT_EQ(label_name(100), "100");
  EXPECT_EQ(label_name(2.5), "2.5");
  EXPECT_EQ(findings(scan_of("100 x=1\n1e2 y=1\n")), "LB0007 2:1; ");
}

TEST(BasicScan, MistakesBeyondAThousandAreNotTold) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "$\n";
  EXPECT_EQ(scan_of(text).findings.size(), 1000U);
}

}  // namespace
}  // namespace kerf::basic
