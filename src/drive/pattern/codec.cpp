#include "drive/pattern/codec.hpp"

#include <fmt/format.h>

#include <cassert>

#include "drive/pattern/axis_name.hpp"

namespace kerf::drive {
namespace {

constexpr unsigned kDirectionBit = 0x80;
constexpr unsigned kAxisShift = 5;
constexpr unsigned kAxisMask = 3;
constexpr unsigned kLowBits = 0x1f;
constexpr unsigned kFastFlag = 0x1f;

bool is_negative(std::uint8_t byte) { return (byte & kDirectionBit) != 0; }
ArmAxis axis_of_byte(std::uint8_t byte) {
  return static_cast<ArmAxis>(byte >> kAxisShift & kAxisMask);
}

std::uint8_t byte_of(ArmAxis axis, bool negative, unsigned low_bits) {
  return static_cast<std::uint8_t>((negative ? kDirectionBit : 0U) |
                                   static_cast<unsigned>(axis) << kAxisShift | low_bits);
}

FastRecord fast_record(const RecordBytes& bytes, ByteOrder order) {
  const unsigned high = order == ByteOrder::big ? bytes[1] : bytes[2];
  const unsigned low = order == ByteOrder::big ? bytes[2] : bytes[1];
  return {axis_of_byte(bytes[0]),
          {static_cast<std::uint16_t>(high << 8U | low), is_negative(bytes[0])}};
}

tl::unexpected<base::Diagnostic> wrong(base::Code code, std::uint64_t offset,
                                       const std::string& what, const std::string& hint = {}) {
  base::Diagnostic diagnostic = base::make_error(code, {}, what, hint);
  diagnostic.offset = offset;
  return base::unexpected(std::move(diagnostic));
}

RecordBytes bytes_of(const FastRecord& record, ByteOrder order) {
  const auto high = static_cast<std::uint8_t>(record.field.pulses >> 8U);
  const auto low = static_cast<std::uint8_t>(record.field.pulses & 0xffU);
  const std::uint8_t flag = byte_of(record.axis, record.field.negative, kFastFlag);
  if (order == ByteOrder::big) return {flag, high, low};
  return {flag, low, high};
}

RecordBytes bytes_of(const Triplet& triplet, ByteOrder /*order*/) {
  RecordBytes bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    assert(triplet.fields[i].pulses <= kMostTripletPulses);
    bytes[i] = byte_of(triplet.axes[i], triplet.fields[i].negative, triplet.fields[i].pulses);
  }
  return bytes;
}

}  // namespace

base::Result<PatternRecord> decode(const RecordBytes& bytes, const PatternFormat& format,
                                   std::uint64_t offset) {
  if ((bytes[0] & kLowBits) == kFastFlag) return fast_record(bytes, format.order);
  Triplet triplet;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint8_t byte = bytes[i];
    if ((byte & kLowBits) == kFastFlag) {
      return wrong(base::Code::pattern_field, offset + i,
                   fmt::format("{:02X}H in the place of {} has the flag of a fast record", byte,
                               axis_name(Triplet::kAxes[i])));
    }
    triplet.axes[i] = axis_of_byte(byte);
    if (triplet.axes[i] != Triplet::kAxes[i] && format.axis_bits == AxisBits::strict) {
      return wrong(base::Code::pattern_axis, offset + i,
                   fmt::format("{:02X}H is of {}, in the place of {}", byte,
                               axis_name(triplet.axes[i]), axis_name(Triplet::kAxes[i])),
                   "--lenient does not look at the axes of triplets");
    }
    triplet.fields[i] = {static_cast<std::uint16_t>(byte & kLowBits), is_negative(byte)};
  }
  return triplet;
}

RecordBytes encode(const PatternRecord& record, ByteOrder order) {
  return std::visit([order](const auto& r) { return bytes_of(r, order); }, record);
}

}  // namespace kerf::drive
