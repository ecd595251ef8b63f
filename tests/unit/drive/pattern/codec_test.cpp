// The bytes of the pattern database: the tables of its description, errors with their offsets, and
// random bytes there and back.
#include "drive/pattern/codec.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "drive/pattern/reader.hpp"
#include "drive/pattern/split.hpp"
#include "seeded_random.hpp"

namespace kerf::drive {
namespace {

using Bytes = std::vector<unsigned>;

template <typename Move>
Bytes bytes_of(const Move& move, ByteOrder order = ByteOrder::big) {
  Bytes bytes;
  each_record(move, [&](const PatternRecord& record) {
    for (const std::uint8_t byte : encode(record, order)) bytes.push_back(byte);
  });
  return bytes;
}

std::string text_of(const Bytes& bytes) {
  std::string text;
  for (const unsigned byte : bytes) text += static_cast<char>(byte);
  return text;
}

struct ReadBack {
  std::vector<PatternRecord> records;
  std::optional<base::Diagnostic> error;
};

ReadBack read_all(const std::string& bytes, const PatternFormat& format = {}) {
  const auto file = base::SourceFile::from_text("test", bytes);
  PatternReader reader(*file, base::FileId{0}, format);
  ReadBack result;
  for (;;) {
    auto record = reader.next();
    if (!record) {
      result.error = record.error();
      return result;
    }
    if (!*record) return result;
    result.records.push_back(**record);
  }
}

std::string written(const std::vector<PatternRecord>& records, ByteOrder order) {
  std::string text;
  for (const PatternRecord& record : records) {
    for (const std::uint8_t byte : encode(record, order)) text += static_cast<char>(byte);
  }
  return text;
}

TEST(PatternFastMove, BytesOfTheTableInBothOrders) {
  struct Row {
    FastMove move;
    Bytes big, little;
  };
  const std::vector<Row> rows = {
      {{ArmAxis::theta1, 1000}, {0x1f, 0x03, 0xe8}, {0x1f, 0xe8, 0x03}},
      {{ArmAxis::theta2, -1000}, {0xbf, 0x03, 0xe8}, {0xbf, 0xe8, 0x03}},
      {{ArmAxis::theta3, 31}, {0x5f, 0x00, 0x1f}, {0x5f, 0x1f, 0x00}},
      {{ArmAxis::z, -65535}, {0xff, 0xff, 0xff}, {0xff, 0xff, 0xff}},
      {{ArmAxis::z, 65536},
       {0x7f, 0xff, 0xff, 0x7f, 0x00, 0x01},
       {0x7f, 0xff, 0xff, 0x7f, 0x01, 0x00}},
      {{ArmAxis::theta1, -70000},
       {0x9f, 0xff, 0xff, 0x9f, 0x11, 0x71},
       {0x9f, 0xff, 0xff, 0x9f, 0x71, 0x11}},
      {{ArmAxis::theta3, 0}, {}, {}},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(bytes_of(row.move), row.big) << row.move.count;
    EXPECT_EQ(bytes_of(row.move, ByteOrder::little), row.little) << row.move.count;
    std::int64_t sum = 0;
    for (const PatternRecord& record :
         read_all(text_of(row.little), {ByteOrder::little, AxisBits::strict}).records) {
      EXPECT_EQ(std::get<FastRecord>(record).axis, row.move.axis);
      sum += std::get<FastRecord>(record).field.count();
    }
    EXPECT_EQ(sum, row.move.count);
  }
}

TEST(PatternCut, BytesOfOneTriplet) {
  const std::vector<std::pair<SlowMove, Bytes>> rows = {
      {{0, 12, -7}, {0x40, 0x0c, 0xa7}},  {{3, 30, 30}, {0x43, 0x1e, 0x3e}},
      {{-30, 0, 1}, {0xde, 0x00, 0x21}},  {{5, 0, 0}, {0x45, 0x00, 0x20}},
      {{0, -1, -30}, {0x40, 0x81, 0xbe}},
  };
  for (const auto& [move, bytes] : rows) {
    EXPECT_EQ(bytes_of(move), bytes);
    const ReadBack back = read_all(text_of(bytes));
    ASSERT_EQ(back.records.size(), 1U);
    EXPECT_EQ(std::get<Triplet>(back.records[0]).move(), move);
  }
}

TEST(PatternCut, BytesOfMovesThatAreSplit) {
  const std::vector<std::pair<SlowMove, Bytes>> rows = {
      {{0, 12, -7}, {0x40, 0x0c, 0xa7}},
      {{0, 45, 10}, {0x40, 0x16, 0x25, 0x40, 0x17, 0x25}},
      {{4, 61, -100}, {0x44, 0x0f, 0xb9, 0x40, 0x0f, 0xb9, 0x40, 0x0f, 0xb9, 0x40, 0x10, 0xb9}},
      {{70, 5, 5}, {0x5e, 0x00, 0x20, 0x5e, 0x00, 0x20, 0x4a, 0x05, 0x25}},
      {{-35, 0, 0}, {0xde, 0x00, 0x20, 0xc5, 0x00, 0x20}},
      {{0, 0, 0}, {}},
      {{2, 31, 0}, {0x42, 0x0f, 0x20, 0x40, 0x10, 0x20}},
      {{0, -90, 89}, {0x40, 0x9e, 0x3d, 0x40, 0x9e, 0x3e, 0x40, 0x9e, 0x3e}},
  };
  for (const auto& [move, bytes] : rows) EXPECT_EQ(bytes_of(move), bytes) << move.theta1;
}

TEST(PatternReader, ReadsTheWorkedStream) {
  const ReadBack back =
      read_all(text_of({0x7f, 0x00, 0xc8, 0x3f, 0x0f, 0xa0, 0x40, 0x0c, 0xa7, 0xff, 0x00, 0xc8}));
  ASSERT_FALSE(back.error);
  ASSERT_EQ(back.records.size(), 4U);
  EXPECT_EQ(std::get<FastRecord>(back.records[0]).move(), (FastMove{ArmAxis::z, 200}));
  EXPECT_EQ(std::get<FastRecord>(back.records[1]).move(), (FastMove{ArmAxis::theta2, 4000}));
  EXPECT_EQ(std::get<Triplet>(back.records[2]).move(), (SlowMove{0, 12, -7}));
  EXPECT_EQ(std::get<FastRecord>(back.records[3]).move(), (FastMove{ArmAxis::z, -200}));
}

TEST(PatternReader, AnEmptyFileHasNoRecords) {
  const ReadBack back = read_all("");
  EXPECT_TRUE(back.records.empty());
  EXPECT_FALSE(back.error);
}

TEST(PatternReader, ErrorsHaveTheOffsetOfTheirByte) {
  struct Row {
    Bytes bytes;
    base::Code code;
    std::uint64_t offset;
  };
  const std::vector<Row> rows = {
      {{0x40}, base::Code::pattern_truncated, 0},
      {{0x40, 0x0c}, base::Code::pattern_truncated, 0},
      {{0x7f, 0x00, 0xc8, 0x1f, 0x00}, base::Code::pattern_truncated, 3},
      {{0x40, 0x1f, 0x20}, base::Code::pattern_field, 1},
      {{0x40, 0x00, 0x3f}, base::Code::pattern_field, 2},
      {{0x7f, 0x00, 0xc8, 0x40, 0x00, 0xbf}, base::Code::pattern_field, 5},
      {{0x00, 0x00, 0x20}, base::Code::pattern_axis, 0},
      {{0x40, 0x20, 0x20}, base::Code::pattern_axis, 1},
      {{0x40, 0x00, 0x60}, base::Code::pattern_axis, 2},
      {{0x40, 0x00, 0x7f}, base::Code::pattern_field, 2},  // the flag comes before the axis
  };
  for (const Row& row : rows) {
    const ReadBack back = read_all(text_of(row.bytes));
    ASSERT_TRUE(back.error);
    EXPECT_EQ(back.error->code, row.code);
    EXPECT_EQ(back.error->offset, row.offset);
    EXPECT_FALSE(back.error->message.empty());
  }
}

TEST(PatternReader, LenientIgnoresAxisBitsButNotFlags) {
  const PatternFormat lenient{ByteOrder::big, AxisBits::lenient};
  const ReadBack odd = read_all(text_of({0x03, 0x64, 0xe5}), lenient);
  ASSERT_EQ(odd.records.size(), 1U);
  EXPECT_EQ(std::get<Triplet>(odd.records[0]).move(), (SlowMove{3, 4, -5}));
  const ReadBack flag = read_all(text_of({0x03, 0x7f, 0xe5}), lenient);
  ASSERT_TRUE(flag.error);
  EXPECT_EQ(flag.error->code, base::Code::pattern_field);
}

TEST(PatternReader, DirectionBitsOfZeroAreKept) {
  const Bytes bytes = {0x9f, 0x00, 0x00, 0xc0, 0x80, 0xa0, 0x40, 0x80, 0x20};
  const ReadBack back = read_all(text_of(bytes));
  ASSERT_EQ(back.records.size(), 3U);
  EXPECT_TRUE(std::get<FastRecord>(back.records[0]).field.negative);
  EXPECT_EQ(std::get<FastRecord>(back.records[0]).move().count, 0);
  EXPECT_EQ(written(back.records, ByteOrder::big), text_of(bytes));
}

std::string random_pattern(test::SeededRandom& random, std::size_t records) {
  std::string bytes;
  for (std::size_t i = 0; i < records; ++i) {
    std::array<unsigned, 3> b{};
    for (unsigned& byte : b) byte = static_cast<unsigned>(random.count(0, 255));
    if ((b[0] & 0x1fU) != 0x1f) {
      for (unsigned& byte : b) byte = (byte & 0x1fU) == 0x1f ? byte - 1 : byte;
    }
    for (const unsigned byte : b) bytes += static_cast<char>(byte);
  }
  return bytes;
}

TEST(PatternProperty, RandomBytesComeBackToTheLastBit) {
  test::SeededRandom random(test::kSeed + 1);
  for (const ByteOrder order : {ByteOrder::big, ByteOrder::little}) {
    const std::string bytes = random_pattern(random, 30'000);  // several buffers of the reader
    const ReadBack back = read_all(bytes, {order, AxisBits::lenient});
    ASSERT_FALSE(back.error);
    EXPECT_EQ(back.records.size(), 30'000U);
    EXPECT_EQ(written(back.records, order), bytes);
  }
}

TEST(PatternProperty, MovesComeBackAsTheirSumInSmallFields) {
  test::SeededRandom random(test::kSeed + 2);
  for (int i = 0; i < 5000; ++i) {
    const int most = i % 3 == 0 ? 40 : 3000;
    const SlowMove move{random.count(-200, 200), random.count(-most, most),
                        random.count(-most, most)};
    SlowMove sum;
    each_record(move, [&](const Triplet& triplet) {
      const auto back = decode(encode(triplet, ByteOrder::big), {}, 0);
      ASSERT_TRUE(back);
      ASSERT_EQ(*back, PatternRecord(triplet));
      for (const PulseField& field : triplet.fields) ASSERT_LE(field.pulses, 30);
      sum.theta1 += triplet.move().theta1;
      sum.theta2 += triplet.move().theta2;
      sum.theta3 += triplet.move().theta3;
    });
    ASSERT_EQ(sum, move);
  }
}

}  // namespace
}  // namespace kerf::drive
