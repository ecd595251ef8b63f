// The text form of patterns: lines there and back, moves that are split, errors with their column.
#include "drive/pattern/listing.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drive/pattern/codec.hpp"
#include "drive/pattern/listing_reader.hpp"
#include "seeded_random.hpp"

namespace kerf::drive {
namespace {

std::string listed(const PatternRecord& record) {
  std::string text;
  append_listing(text, record);
  return text;
}

std::vector<PatternRecord> records_of(const std::string& line) {
  std::vector<PatternRecord> records;
  const auto move = parse_listing(line, {});
  EXPECT_TRUE(move) << line;
  if (move) each_record(*move, [&](const PatternRecord& record) { records.push_back(record); });
  return records;
}

TEST(PatternListing, LinesOfRecords) {
  EXPECT_EQ(listed(FastRecord{ArmAxis::z, {200, false}}), "F Z 200");
  EXPECT_EQ(listed(FastRecord{ArmAxis::theta2, {65535, true}}), "F T2 -65535");
  EXPECT_EQ(listed(FastRecord{ArmAxis::theta1, {0, true}}), "F T1 -0");
  EXPECT_EQ(listed(FastRecord{ArmAxis::theta3, {0, false}}), "F T3 0");
  EXPECT_EQ(listed(Triplet{{PulseField{0, false}, {12, false}, {7, true}}, Triplet::kAxes}),
            "S 0 12 -7");
  EXPECT_EQ(listed(Triplet{{PulseField{0, true}, {0, true}, {30, true}}, Triplet::kAxes}),
            "S -0 -0 -30");
}

TEST(PatternListing, FourLinkedMotorsAreALineWithoutBytes) {
  const auto move = parse_listing("L 12 -7 0 65535 # all", {}, Links::four);
  ASSERT_TRUE(move);
  const ArmCounts& counts = std::get<ListedLinked>(*move).counts;
  EXPECT_EQ(counts[ArmAxis::theta1], 12);
  EXPECT_EQ(counts[ArmAxis::theta2], -7);
  EXPECT_EQ(counts[ArmAxis::theta3], 0);
  EXPECT_EQ(counts[ArmAxis::z], 65535);
  each_record(*move, [](const PatternRecord& record) { ADD_FAILURE() << listed(record); });
  const auto without = parse_listing(" L 1 2 3 4", {});
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().message.find("has no bytes"), std::string::npos);
  EXPECT_EQ(without.error().place.column, 2U);
  for (const char* const line : {"L 1 2 3", "L 1 2 3 4 5", "L 1 2 3 65536", "L T1 2 3 4"})
    EXPECT_FALSE(parse_listing(line, {}, Links::four)) << line;
}

TEST(PatternListing, AListingIsToldFromBytesByItsBeginning) {
  for (const char* const text :
       {"F T1 3\n", "S 1 2 3", "L 1 2 3 4", "# head\nF Z 1", "\n", " F Z 1"})
    EXPECT_TRUE(begins_listing(text)) << text;
  for (const char* const text : {"", "F", "FT", "S\t1"}) EXPECT_FALSE(begins_listing(text)) << text;
  test::SeededRandom random(test::kSeed);
  for (int i = 0; i < 100'000; ++i) {
    RecordBytes bytes{};
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.count(0, 255));
    const std::string text(bytes.begin(), bytes.end());
    EXPECT_FALSE(decode(bytes, {}, 0) && begins_listing(text)) << text;
  }
}

TEST(PatternListing, ALineWithinTheLimitsIsThatRecord) {
  for (const char* const line :
       {"F T1 0", "F Z -0", "F T3 65535", "S 0 0 0", "S -0 0 -0", "S 30 -30 30"}) {
    const auto records = records_of(line);
    ASSERT_EQ(records.size(), 1U) << line;
    EXPECT_EQ(listed(records[0]), line);
  }
}

TEST(PatternListing, BeyondTheLimitsItIsAMove) {
  const auto lines = [](const std::string& line) {
    std::string text;
    for (const PatternRecord& record : records_of(line)) text += listed(record) + ";";
    return text;
  };
  EXPECT_EQ(lines("F Z 65536"), "F Z 65535;F Z 1;");
  EXPECT_EQ(lines("F T1 -70000"), "F T1 -65535;F T1 -4465;");
  EXPECT_EQ(lines("S 0 45 10"), "S 0 22 5;S 0 23 5;");
  EXPECT_EQ(lines("S 70 5 5"), "S 30 0 0;S 30 0 0;S 10 5 5;");
  EXPECT_EQ(records_of("F T1 2147483647").size(), 32769U);
}

TEST(PatternListing, BlanksSignsAndComments) {
  EXPECT_EQ(listed(records_of("  F\tZ  +7  # up\r").at(0)), "F Z 7");
  EXPECT_TRUE(records_of("").empty());
  EXPECT_TRUE(records_of("   # only words").empty());
}

TEST(PatternListing, ErrorsSayWhereAndWhatIsExpected) {
  struct Row {
    const char* line;
    std::uint32_t column;
    const char* says;
  };
  const Row rows[] = {{"G T1 5", 1, "F or S"},
                      {"F T4 5", 3, "an axis"},
                      {"F t1 5", 3, "an axis"},
                      {"F", 2, "an axis"},
                      {"F T1", 5, "pulses of T1"},
                      {"F T1 5.5", 6, "whole number"},
                      {"F T1 --5", 6, "pulses of T1"},
                      {"F T1 0x1", 6, "whole number"},
                      {"S 1 2", 6, "pulses of T2"},
                      {"S 1 x 3", 5, "pulses of T1"},
                      {"S 1 2 3 4", 9, "nothing more"},
                      {"F T1 2147483648", 6, "2147483647"},
                      {"F Z 99999999999999999999", 5, "2147483647"},
                      {"F T1 -", 6, "whole number"}};
  for (const Row& row : rows) {
    const auto move = parse_listing(row.line, {.line = 7});
    ASSERT_FALSE(move) << row.line;
    EXPECT_EQ(move.error().code, base::Code::pattern_text);
    EXPECT_EQ(move.error().place.line, 7U);
    EXPECT_EQ(move.error().place.column, row.column) << row.line;
    EXPECT_NE(move.error().message.find(row.says), std::string::npos) << move.error().message;
  }
}

TEST(ListingReader, CountsLinesAndTakesTheLastOneWithoutItsEnd) {
  const auto file = base::SourceFile::from_text("list", "\n# head\r\nF Z 1\r\n\nS 1 2 3\nF Q 1");
  ListingReader reader(*file, base::FileId{3});
  EXPECT_TRUE(std::holds_alternative<ListedFast>(*reader.next().value()));
  EXPECT_TRUE(std::holds_alternative<ListedSlow>(*reader.next().value()));
  const auto wrong = reader.next();
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().place.line, 6U);
  EXPECT_EQ(wrong.error().place.column, 3U);
  EXPECT_EQ(wrong.error().place.file, base::FileId{3});
  EXPECT_EQ(file->line_at(wrong.error().place.line_start, 80), "F Q 1");
}

TEST(ListingReader, LongFilesAndLinesTooLong) {
  std::string text;
  for (int i = 0; i < 50'000; ++i) text += "S 1 2 3\n";
  const auto file = base::SourceFile::from_text("list", text + std::string(5000, ' ') + "\n");
  ListingReader reader(*file, base::FileId{0});
  for (int i = 0; i < 50'000; ++i) ASSERT_TRUE(reader.next().value());
  const auto wrong = reader.next();
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().place.line, 50'001U);
}

TEST(PatternProperty, RandomRecordsComeBackFromTheirLines) {
  test::SeededRandom random(test::kSeed + 3);
  const auto field = [&](int most) {
    return PulseField{static_cast<std::uint16_t>(random.count(0, most)), random.count(0, 1) == 1};
  };
  for (int i = 0; i < 20'000; ++i) {
    const PatternRecord record =
        i % 2 == 0
            ? PatternRecord(FastRecord{static_cast<ArmAxis>(random.count(0, 3)), field(65535)})
            : PatternRecord(Triplet{{field(30), field(30), field(30)}, Triplet::kAxes});
    const auto back = records_of(listed(record));
    ASSERT_EQ(back.size(), 1U);
    ASSERT_EQ(back[0], record);
  }
}

}  // namespace
}  // namespace kerf::drive
