#pragma once

#include <optional>
#include <string>

#include "base/source_file.hpp"
#include "drive/pattern/listing.hpp"

namespace kerf::drive {

/// Reads a listing line by line, in a few KiB of memory whatever its size. Lines end in LF or CR
/// LF; the last one need not.
class ListingReader {
 public:
  static constexpr std::size_t kLongestLine = 4096;  ///< bytes, comments included

  /// The file must outlive the reader; `id` is what its errors name it by.
  ListingReader(const base::SourceFile& file, base::FileId id, Links links = Links::none)
      : file_(file), id_(id), links_(links) {}

  /// The next line that says something; nothing at the end. Error PATTERN_TEXT with its place. Not
  /// to be called after one.
  [[nodiscard]] base::Result<std::optional<ListedMove>> next();
  /// Of the line given last.
  [[nodiscard]] const base::Place& place() const { return place_; }

 private:
  bool next_line();
  bool fill();

  const base::SourceFile& file_;
  base::FileId id_;
  Links links_;
  std::string buffer_;
  std::size_t at_ = 0;       // of the next line in the buffer
  std::uint64_t begin_ = 0;  // of the buffer in the file
  std::string_view line_;    // the present one, in the buffer
  bool too_long_ = false;    // the present line
  base::Place place_;
};

}  // namespace kerf::drive
