#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "lang/teach/record_parser.hpp"
#include "taught_text.hpp"

namespace kerf::test {
namespace {

using teach::Pose;
using teach::Record;
using Strings = std::vector<std::string>;

// The records, wrapped so that nothing around them is wrong.
TaughtText read_path(const std::string& lines) {
  return read_taught("TEACH 1\nFEED 100\nPOINT 0 0 0 0 0\n" + lines + "\nEND\n");
}

TEST(TaughtRecord, EveryRecordReadsAsItIsWritten) {
  const TaughtText read = read_taught(
      "TEACH 1 ; first\n"
      "units Mm dEg\n"
      "PERIOD,8\n"
      "\tRADII 150,80 ; of the head\n"
      "\n"
      "; a comment, with 1 2 3; and more\n"
      "POINT 1, 2.5, -3e1, +4, .5 edge_1\n"
      "Feed 3000\n"
      "LASER ON 40%\n"
      "LASER OFF\n"
      "LINE 1 2 3 4 5\n"
      "ARC 6 7 8 9 10 11 12 14 14 15\n"
      "CIRCLE 16 17 18 19 20 21 22 23.5 24 25\n"
      "DWELL 0.25\n"
      "laser on\n"
      "END;\n");
  EXPECT_EQ(read.mistakes, Strings{});
  const std::vector<Record> wanted = {teach::Version{},
                                      teach::Units{},
                                      teach::Period{8},
                                      teach::Radii{150, 80},
                                      teach::Point{{1, 2.5, -30, 4, 0.5}, teach::Name("edge_1")},
                                      teach::Feed{3000},
                                      teach::Laser{true, 40},
                                      teach::Laser{false, std::nullopt},
                                      teach::Line{{1, 2, 3, 4, 5}},
                                      teach::Arc{{6, 7, 8, 9, 10}, {11, 12, 14, 14, 15}},
                                      teach::Circle{{16, 17, 18, 19, 20}, {21, 22, 23.5, 24, 25}},
                                      teach::Dwell{0.25},
                                      teach::Laser{true, std::nullopt},
                                      teach::End{}};
  EXPECT_EQ(read.records, wanted);
  EXPECT_EQ(read.rewritten,
            "TEACH 1 ; first\nUNITS MM DEG\nPERIOD 8\nRADII 150 80 ; of the head\n\n"
            "; a comment, with 1 2 3; and more\nPOINT 1 2.5 -30 4 0.5 edge_1\nFEED 3000\n"
            "LASER ON 40\nLASER OFF\nLINE 1 2 3 4 5\nARC 6 7 8 9 10 11 12 14 14 15\n"
            "CIRCLE 16 17 18 19 20 21 22 23.5 24 25\nDWELL 0.25\nLASER ON\nEND ;\n");
}

TEST(TaughtRecord, WhatWasWrittenIsWrittenTheSameAgain) {
  const std::string once =
      read_taught("teach  1;x\r\nPOINT 1e-3 0.1 1e5 -0 123456.7890625 ;y \nfeed 1E2\r\nend")
          .rewritten;
  EXPECT_EQ(once, "TEACH 1 ;x\nPOINT 0.001 0.1 100000 -0 123456.7890625 ;y \nFEED 100\nEND\n");
  EXPECT_EQ(read_taught(once).rewritten, once);
}

TEST(TaughtRecord, LinesEndAtLineFeedOrReturnOrBoth) {
  for (const char* const end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char* const line : {"TEACH 1", "POINT 1 2 3 4 5 a", "", "FEEDS 1", "END"})
      text += std::string(line) + end;
    const TaughtText read = read_taught(text);
    EXPECT_EQ(read.mistakes, Strings{"TEACH_RECORD 4:1+5"});
    EXPECT_EQ(read.records.size(), 3U);
  }
}

TEST(TaughtRecord, EveryDoubleReadsBackBitForBit) {
  std::mt19937_64 random(20260801);
  std::vector<double> values = {
      0.0, -0.0,  0.1, 1.0 / 3, 5e-324, 2.2250738585072014e-308, 1e6, -1e6, std::nextafter(1e6, 0),
      90,  1e-300};
  while (values.size() < 100'000) {
    const double any = std::bit_cast<double>(random());
    if (std::fabs(any) <= teach::kMostCoordinate) values.push_back(any);
    values.push_back(std::uniform_real_distribution<>(-1000, 1000)(random));
  }
  for (std::size_t i = 0; i + 4 < values.size(); i += 5) {
    const Record record =
        teach::Line{{values[i], values[i + 1], values[i + 2], values[i + 3], values[i + 4]}};
    std::string line;
    teach::append_record(line, record);
    const auto read = teach::parse_record(teach::Words(line));
    ASSERT_TRUE(read.has_value()) << line;
    const Pose& back = std::get<teach::Line>(*read).to;
    for (const auto& [got, n] : {std::pair{back.x, i},
                                 {back.y, i + 1},
                                 {back.z, i + 2},
                                 {back.a_deg, i + 3},
                                 {back.c_deg, i + 4}})
      ASSERT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(values[n])) << line;
    std::string again;
    teach::append_record(again, *read);
    ASSERT_EQ(again, line);
  }
}

TEST(TaughtRecord, MistakesHaveLineColumnAndLength) {
  const std::pair<const char*, const char*> cases[] = {
      {"G01 X10", "TEACH_RECORD 4:1+3"},
      {"  LINES 1 2 3 4 5", "TEACH_RECORD 4:3+5"},
      {"LASER DIM", "TEACH_RECORD 4:7+3"},
      {"LINE 1 2 3 4", "TEACH_COUNT 4:1+4"},
      {"LINE 1 2 3 4 5 6", "TEACH_COUNT 4:16+1"},
      {"ARC 1 2 3 4 5 6 7 8 9", "TEACH_COUNT 4:1+3"},
      {"ARC 1 2 3 4 5 6 7 8 9 0 77", "TEACH_COUNT 4:25+2"},
      {"POINT 1 2 3 4 5 two names", "TEACH_COUNT 4:21+5"},
      {"FEED", "TEACH_COUNT 4:1+4"},
      {"LASER", "TEACH_COUNT 4:1+5"},
      {"END 1", "TEACH_COUNT 4:5+1"},
      {"LINE 1 2 3 4 5x", "TEACH_NUMBER 4:14+2"},
      {"LINE 1 2 3. -.4 --5", "TEACH_NUMBER 4:17+3"},
      {"LINE 1 2 3 4 inf", "TEACH_NUMBER 4:14+3"},
      {"LINE 1 nan 3 4 5", "TEACH_NUMBER 4:8+3"},
      {"LINE 1 2 3 4 1e999", "TEACH_NUMBER 4:14+5"},
      {"LINE 1 2 3 4 0x10", "TEACH_NUMBER 4:14+4"},
      {"DWELL .", "TEACH_NUMBER 4:7+1"},
      {"DWELL +-1", "TEACH_NUMBER 4:7+3"},
      {"FEED 0", "TEACH_RANGE 4:6+1"},
      {"FEED -5", "TEACH_RANGE 4:6+2"},
      {"LASER ON 101", "TEACH_RANGE 4:10+3"},
      {"LASER ON %", "TEACH_NUMBER 4:10+1"},
      {"DWELL -1", "TEACH_RANGE 4:7+2"},
      {"PERIOD 0", "TEACH_RANGE 4:8+1"},
      {"LINE 1000001 0 0 0 0", "TEACH_RANGE 4:6+7"},
      {"TEACH 2", "TEACH_VERSION 4:7+1"},
      {"TEACH 1", "TEACH_ORDER 4:1+5"},
      {"UNITS INCH DEG", "TEACH_UNIT 4:7+4"},
      {"UNITS MM, RAD", "TEACH_UNIT 4:11+3"},
      {"ARC 1 0 0 0 0  1 0 0 5 5", "ARC_COINCIDENT 4:1+3"},
      {"ARC 0 0 0 1 1  1 0 0 5 5", "ARC_COINCIDENT 4:1+3"},
      {"ARC 5 1 0 0 0  0 0 0 5 5", "ARC_COINCIDENT 4:1+3"},
      {"ARC 2 2 2 0 0  1 1 1 0 0", "ARC_COLLINEAR 4:1+3"},
      {"ARC -1 0 0 0 0 9 0 0 0 0", "ARC_COLLINEAR 4:1+3"},
      {"CIRCLE 1 0 0 0 0 2 0 0 0 0", "ARC_COLLINEAR 4:1+6"},
      {"CIRCLE 1 0 0 0 0 0 0 0 0 0", "ARC_COINCIDENT 4:1+6"},
  };
  for (const auto& [line, wanted] : cases)
    EXPECT_EQ(read_path(line).mistakes, Strings{wanted}) << line;
}

TEST(TaughtRecord, AnArcOverAPointBetweenItsEndsIsNoMistake) {
  EXPECT_EQ(read_path("ARC 1 2 3 10 20  2 4 6 0 0").mistakes, Strings{});
}

TEST(TaughtRecord, RecordsStandInOrder) {
  const std::pair<const char*, Strings> cases[] = {
      {"", {"EMPTY_PROGRAM 1:1+0"}},
      {"; nothing\n\n", {"EMPTY_PROGRAM 1:1+0"}},
      {"UNITS MM DEG\nEND", {"TEACH_VERSION 1:1+5"}},
      {"TEACH 0\nFEED 1\nEND", {"TEACH_VERSION 1:7+1"}},
      {"TEACH 1\nFEED 5\nLINE 1 2 3 4 5\nEND", {"TEACH_ORDER 3:1+4"}},
      {"TEACH 1\nFEED 5\nARC 1 2 3 4 5 6 7 8 9 1\nEND", {"TEACH_ORDER 3:1+3"}},
      {"TEACH 1\nFEED 5\nCIRCLE 1 2 3 4 5 6 7 8 9 1\nEND", {"TEACH_ORDER 3:1+6"}},
      {"TEACH 1\nPOINT 1 2 3 4 5\n LINE 1 2 3 4 6\nEND", {"TEACH_ORDER 3:2+4"}},
      {"TEACH 1\nPOINT 1 2 3 4 5\n;no end", {"TEACH_ORDER 2:1+0"}},
      {"TEACH 1\nEND\n; well\n", {}},
      {"TEACH 1\nEND\n\n DWELL 1\nx", {"TEACH_ORDER 4:2+5", "TEACH_ORDER 5:1+1"}},
      {"TEACH 1\nEND\nEND", {"TEACH_ORDER 3:1+3"}},
  };
  for (const auto& [text, wanted] : cases) EXPECT_EQ(read_taught(text).mistakes, wanted) << text;
}

TEST(TaughtRecord, AMistakeHidesNothingBehindItAndInventsNothing) {
  const TaughtText read = read_taught(
      "TEACH 1\nPOINT 0 0 0 0\nFEED x\nLINE 1 0 0 0 0\nARC 2 0 0 0 0 0 0 0 0 0\nLINE 1\nEND\n");
  EXPECT_EQ(read.mistakes, (Strings{"TEACH_COUNT 2:1+5", "TEACH_NUMBER 3:6+1",
                                    "ARC_COLLINEAR 5:1+3", "TEACH_COUNT 6:1+4"}));
}

TEST(TaughtRecord, NonsenseIsToldOfAndEnds) {
  std::mt19937 random(7);
  std::string bytes;
  for (int i = 0; i < 100'000; ++i) bytes += static_cast<char>(random());
  EXPECT_FALSE(read_taught(bytes).mistakes.empty());
  EXPECT_EQ(read_taught("TEACH 1\n" + std::string(3 << 20, 'x') + "\nLINE 1\nEND").mistakes,
            (Strings{"BLOCK_TOO_LONG 2:1+0", "TEACH_COUNT 3:1+4"}));
  EXPECT_EQ(read_taught("TEACH 1\nEND ;" + std::string(500'000, 'y') + "\r\n;z").mistakes,
            Strings{});
  EXPECT_EQ(read_taught("TEACH 1\nPOINT 1 2 3 4 5 " + std::string(64, 'n') + "\nEND").mistakes,
            Strings{"TEACH_RANGE 2:17+64"});
  EXPECT_EQ(read_taught(std::string("TEACH 1\0\nEND", 12)).mistakes, Strings{"TEACH_NUMBER 1:7+2"});
}

}  // namespace
}  // namespace kerf::test
