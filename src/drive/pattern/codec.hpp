#pragma once

#include <array>
#include <cstdint>

#include "base/result.hpp"
#include "drive/pattern/record.hpp"

namespace kerf::drive {

// Records as bytes and back (docs/pattern.md, "Bytes").

/// Which byte of a fast record's count comes first.
enum class ByteOrder : std::uint8_t { big, little };

/// Whether the axis bits of triplets must be those of T3, T1, T2.
enum class AxisBits : std::uint8_t { strict, lenient };

struct PatternFormat {
  ByteOrder order = ByteOrder::big;
  AxisBits axis_bits = AxisBits::strict;
};

/// Every record has this many bytes.
inline constexpr std::size_t kRecordBytes = 3;
using RecordBytes = std::array<std::uint8_t, kRecordBytes>;

/// The record that three bytes hold, with every bit of them: encode() gives the same bytes.
/// `offset` is where they stand in the file. Errors, with the offset of the byte: PATTERN_FIELD,
/// the second or third byte of a triplet has the flag of a fast record; PATTERN_AXIS, its axis bits
/// are not those of its place, unless lenient.
[[nodiscard]] base::Result<PatternRecord> decode(const RecordBytes& bytes,
                                                 const PatternFormat& format, std::uint64_t offset);

/// The bytes of a record. Fields within their ranges are the caller's business.
[[nodiscard]] RecordBytes encode(const PatternRecord& record, ByteOrder order);

}  // namespace kerf::drive
