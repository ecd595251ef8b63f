#pragma once

#include <optional>
#include <vector>

#include "base/source_file.hpp"
#include "drive/pattern/codec.hpp"

namespace kerf::drive {

/// Reads the records of a pattern one by one, in a few KiB of memory whatever its size.
class PatternReader {
 public:
  /// The file must outlive the reader; `id` is what its errors name it by.
  PatternReader(const base::SourceFile& file, base::FileId id, const PatternFormat& format);

  /// The next record; nothing at the end of the file. Errors: those of decode(), and
  /// PATTERN_TRUNCATED with the offset of a record that is not whole. Not to be called after one.
  [[nodiscard]] base::Result<std::optional<PatternRecord>> next();

  /// Of the record given last.
  [[nodiscard]] std::uint64_t offset() const { return offset_; }
  /// Records given so far.
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  static constexpr std::size_t kBufferRecords = 4096;

  void fill();

  const base::SourceFile& file_;
  base::FileId id_;
  PatternFormat format_;
  std::vector<char> buffer_;
  std::size_t size_ = 0;      // bytes in the buffer
  std::size_t at_ = 0;        // of the next record in it
  std::uint64_t read_ = 0;    // bytes of the file before the end of the buffer
  std::uint64_t offset_ = 0;  // of the record given last
  std::uint64_t count_ = 0;
};

}  // namespace kerf::drive
