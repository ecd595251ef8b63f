// Any bytes as a pattern, and as a listing of one: reading ends in records or in an error with its
// place. What is a pattern comes back to the last bit through its records, and through its listing
// where no axis bits are odd; what is a listing becomes records that move as much as it says. The
// first byte chooses what the others are.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "drive/arm_drive.hpp"
#include "drive/pattern/listing_reader.hpp"
#include "drive/pattern/reader.hpp"

namespace {

using namespace kerf;
using drive::ArmAxis;
using drive::ArmCounts;
using drive::PatternRecord;

constexpr std::int64_t kMostPulses = 20'000;  // that are really made

void require(bool condition) {
  if (!condition) std::abort();
}

struct NoPulses : drive::PulseSink {
  void take(const drive::Pulse& pulse) override { require(pulse.width_ns > 0); }
};

void add(ArmCounts& counts, const PatternRecord& record) {
  if (const auto* const fast = std::get_if<drive::FastRecord>(&record)) {
    counts[fast->axis] += fast->move().count;
    return;
  }
  const drive::SlowMove move = std::get<drive::Triplet>(record).move();
  counts[ArmAxis::theta3] += move.theta3;
  counts[ArmAxis::theta1] += move.theta1;
  counts[ArmAxis::theta2] += move.theta2;
}

std::string encoded(const PatternRecord& record, drive::ByteOrder order) {
  std::string bytes;
  for (const std::uint8_t byte : drive::encode(record, order)) bytes += static_cast<char>(byte);
  return bytes;
}

void require_same_from_listing(const PatternRecord& record) {
  std::string line;
  drive::append_listing(line, record);
  const auto move = drive::parse_listing(line, {});
  require(move.has_value());
  int records = 0;
  each_record(*move, [&](const PatternRecord& again) {
    require(again == record);
    ++records;
  });
  require(records == 1);
}

void read_pattern(const std::string& bytes, const drive::PatternFormat& format) {
  const auto file = base::SourceFile::from_text("-", bytes);
  drive::PatternReader reader(*file, base::FileId{0}, format);
  NoPulses none;
  drive::ArmDrive arm({}, none);
  ArmCounts counts;
  std::string again;
  std::int64_t pulses = 0;
  for (;;) {
    const auto record = reader.next();
    if (!record) {
      require(record.error().offset && *record.error().offset < bytes.size());
      require(*record.error().offset - again.size() < drive::kRecordBytes);
      return;
    }
    if (!*record) break;
    again += encoded(**record, format.order);
    if (format.axis_bits == drive::AxisBits::strict) require_same_from_listing(**record);
    const auto* const fast = std::get_if<drive::FastRecord>(&**record);
    pulses += fast != nullptr ? fast->field.pulses : 3 * drive::kMostTripletPulses;
    if (pulses > kMostPulses) continue;
    add(counts, **record);
    if (fast != nullptr) {
      arm.fast(fast->move());
    } else {
      require(arm.slow(std::get<drive::Triplet>(**record).move()).has_value());
    }
    require(arm.counters() == counts);
  }
  require(again == bytes);
}

void require_sum(const drive::ListedMove& move) {
  ArmCounts wanted;
  std::int64_t size = 0;
  if (const auto* const fast = std::get_if<drive::ListedFast>(&move)) {
    wanted[fast->axis] = fast->count.count();
  } else if (const auto* const slow = std::get_if<drive::ListedSlow>(&move)) {
    for (std::size_t i = 0; i < slow->counts.size(); ++i) {
      wanted[drive::Triplet::kAxes[i]] = slow->counts[i].count();
      size += slow->counts[i].size;
    }
  }
  if (size > kMostPulses) return;
  ArmCounts sum;
  each_record(move, [&](const PatternRecord& record) {
    const auto* const triplet = std::get_if<drive::Triplet>(&record);
    for (std::size_t i = 0; triplet != nullptr && i < triplet->fields.size(); ++i)
      require(triplet->fields[i].pulses <= drive::kMostTripletPulses);
    require(drive::decode(drive::encode(record, drive::ByteOrder::big), {}, 0) == record);
    add(sum, record);
  });
  require(sum == wanted);
}

void read_listing(const std::string& text) {
  const auto file = base::SourceFile::from_text("-", text);
  drive::ListingReader reader(*file, base::FileId{0});
  for (;;) {
    const auto move = reader.next();
    if (!move) {
      const base::Place& place = move.error().place;
      require(place.line > 0 && place.column > 0 && place.line_start <= text.size());
      return;
    }
    if (!*move) return;
    require_sum(**move);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string rest(reinterpret_cast<const char*>(data + 1), size - 1);
  const bool little = (data[0] & 1U) != 0;
  const bool lenient = (data[0] & 2U) != 0;
  if ((data[0] & 4U) != 0) {
    read_listing(rest);
  } else {
    read_pattern(rest, {little ? drive::ByteOrder::little : drive::ByteOrder::big,
                        lenient ? drive::AxisBits::lenient : drive::AxisBits::strict});
  }
  return 0;
}
