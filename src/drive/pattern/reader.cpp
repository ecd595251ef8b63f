#include "drive/pattern/reader.hpp"

#include <algorithm>
#include <string>

namespace kerf::drive {

PatternReader::PatternReader(const base::SourceFile& file, base::FileId id,
                             const PatternFormat& format)
    : file_(file), id_(id), format_(format), buffer_(kBufferRecords * kRecordBytes) {}

void PatternReader::fill() {
  size_ = file_.read(read_, buffer_);
  read_ += size_;
  at_ = 0;
}

base::Result<std::optional<PatternRecord>> PatternReader::next() {
  if (at_ == size_) fill();
  if (size_ == 0) return std::nullopt;
  offset_ = read_ - size_ + at_;
  const std::size_t there = std::min(size_ - at_, kRecordBytes);
  if (there < kRecordBytes) {
    base::Diagnostic broken =
        base::make_error(base::Code::pattern_truncated, {.file = id_},
                         "a record has 3 bytes, the last one " + std::to_string(there));
    broken.offset = offset_;
    return base::unexpected(std::move(broken));
  }
  RecordBytes bytes{};
  std::transform(buffer_.begin() + static_cast<std::ptrdiff_t>(at_),
                 buffer_.begin() + static_cast<std::ptrdiff_t>(at_ + kRecordBytes), bytes.begin(),
                 [](char c) { return static_cast<std::uint8_t>(c); });
  auto record = decode(bytes, format_, offset_);
  if (!record) {
    record.error().place.file = id_;
    return base::unexpected(std::move(record.error()));
  }
  at_ += kRecordBytes;
  ++count_;
  return *record;
}

}  // namespace kerf::drive
