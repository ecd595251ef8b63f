#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "base/source_file.hpp"

namespace kerf::base {

/// Longest block, and longest line, in bytes. A longer one raises BLOCK_TOO_LONG.
inline constexpr std::size_t kLongestBlock = 1 << 20;

/// The text without U+FEFF in UTF-8, which some editors put in front of a file: it means nothing in
/// any language. For the first line of a file.
[[nodiscard]] inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// Hands out the lines of a stretch of a file one after the other. Holds some of its text at a
/// time, and keeps what it has when the next stretch goes on where the last one stopped.
class TextWindow {
 public:
  struct Line {
    std::string_view text;     ///< without its end; valid until the next call
    std::uint64_t offset = 0;  ///< of its first byte in the file
    bool complete = false;     ///< a line end stands behind it
    bool too_long = false;     ///< longer than kLongestBlock: `text` is empty
    bool may_split = false;    ///< it may hold a semicolon
  };

  /// The next lines are those from byte `begin` up to byte `end`.
  void stand_at(const SourceFile& file, FileId id, std::uint64_t begin, std::uint64_t end);

  /// The next line; false at the end of the stretch.
  [[nodiscard]] bool next(Line& line);

  /// Where the next line begins.
  [[nodiscard]] std::uint64_t position() const { return at_ + position_; }
  /// False when the file is shorter than the stretch: it has been cut off since it was opened.
  [[nodiscard]] bool more() { return position_ < size_ || fill(); }
  [[nodiscard]] bool at_end() const { return position() >= end_; }

 private:
  struct LineEnd {
    std::size_t text = 0;  // where the line's text ends
    std::size_t next = 0;  // where the next line begins
  };

  bool fill();
  void drop_past();
  [[nodiscard]] bool find_end(std::size_t from, LineEnd& end) const;
  [[nodiscard]] bool find_end_with_returns(std::size_t from, LineEnd& end) const;
  [[nodiscard]] char before(std::size_t position) const;
  void skip_long_line();
  [[nodiscard]] std::string_view view() const { return {buffer_.get(), size_}; }

  const SourceFile* file_ = nullptr;
  FileId id_ = kNoFile;
  std::uint64_t end_ = 0;  // of the stretch, in the file
  std::unique_ptr<char[]> buffer_;
  std::size_t capacity_ = 0;
  std::size_t size_ = 0;      // bytes in the buffer
  std::uint64_t at_ = 0;      // file offset of the buffer's first byte
  std::size_t position_ = 0;  // of the next line in the buffer
  char before_ = 0;           // the character in front of the buffer; 0: none
  bool has_returns_ = false;  // the buffer holds a CR
  bool has_semicolons_ = false;
};

}  // namespace kerf::base
