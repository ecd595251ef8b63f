#include "face/server/protocol/pattern_text.hpp"

#include "base/refusal.hpp"
#include "drive/pattern/listing_reader.hpp"
#include "drive/pattern/reader.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::server {
namespace {

using base::Outcome;
using base::Refusal;

constexpr base::FileId kFile{0};

tl::unexpected<base::Failure> too_long(const std::string& name) {
  return tl::unexpected(
      base::refuse(Refusal::pattern_long, {name, std::to_string(kMostPatternBytes / (1U << 20U))}));
}

// "PATTERN_FIELD no number of pulses: 1FH in the place of T1 …"
std::string words_of(const base::Diagnostic& diagnostic) {
  return diagnostic.number + " " + diagnostic.message;
}

// Records of a line are counted before they are made: one may be millions.
std::uint64_t records_of(const drive::ListedMove& move) {
  const auto parts = [](std::int64_t size, std::int64_t most) {
    return static_cast<std::uint64_t>((size + most - 1) / most);
  };
  if (const auto* const fast = std::get_if<drive::ListedFast>(&move))
    return parts(fast->count.size, drive::kMostFastPulses);
  std::uint64_t records = 0;
  if (const auto* const slow = std::get_if<drive::ListedSlow>(&move)) {
    for (const drive::ListedCount& count : slow->counts)
      records += parts(count.size, drive::kMostTripletPulses);
  }
  return records;
}

}  // namespace

bool is_pattern(const std::string& name) { return machine::ends_as_pattern(name); }

Outcome<std::string> listing_of(const base::SourceFile& pattern, const std::string& name,
                                drive::ByteOrder order) {
  if (pattern.size() > kMostPatternBytes) return too_long(name);
  drive::PatternReader reader(pattern, kFile, {order, drive::AxisBits::strict});
  std::string listing;
  for (;;) {
    const auto record = reader.next();
    if (!record) {
      const base::Diagnostic& wrong = record.error();
      return tl::unexpected(base::refuse(Refusal::pattern_broken,
                                         {name, std::to_string(wrong.offset.value_or(0)),
                                          std::to_string(reader.count() + 1), words_of(wrong)}));
    }
    if (!*record) return listing;
    drive::append_listing(listing, **record);
    listing += '\n';
  }
}

Outcome<std::string> listing_of(const std::string& bytes, const std::string& name,
                                drive::ByteOrder order) {
  return listing_of(*base::SourceFile::from_text(name, bytes), name, order);
}

Outcome<std::string> bytes_of(const std::string& listing, const std::string& name,
                              drive::ByteOrder order) {
  const auto file = base::SourceFile::from_text(name, listing);
  drive::ListingReader reader(*file, kFile);
  std::string bytes;
  for (;;) {
    const auto move = reader.next();
    if (!move) {
      const base::Diagnostic& wrong = move.error();
      return tl::unexpected(base::refuse(Refusal::pattern_line,
                                         {name, std::to_string(wrong.place.line),
                                          std::to_string(wrong.place.column), words_of(wrong)}));
    }
    if (!*move) return bytes;
    if (bytes.size() + records_of(**move) * drive::kRecordBytes > kMostPatternBytes)
      return too_long(name);
    drive::each_record(**move, [&](const drive::PatternRecord& record) {
      for (const std::uint8_t byte : drive::encode(record, order)) bytes += static_cast<char>(byte);
    });
  }
}

}  // namespace kerf::server
