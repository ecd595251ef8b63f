#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/source_file.hpp"
#include "base/text_window.hpp"

namespace kerf::drawing::dxf {

/// Two lines of the file: a code, and what it is the code of.
struct RawGroup {
  int code = 0;
  std::uint32_t line = 0;  ///< of the value; its code stands in the one before
  std::string_view value;  ///< without blanks behind; valid until the next call
};

[[nodiscard]] std::string_view without_blanks(std::string_view text);

/// Hands out the groups of a file one after the other.
class GroupReader {
 public:
  enum class Outcome : std::uint8_t { group, end, broken };

  GroupReader(const base::SourceFile& file, base::FileId id);

  /// The next one. `broken`: the line line() has no code, or is longer than any; fault() says so.
  Outcome next(RawGroup& group);
  /// Behind a fault: on to the next group 0 with a word, which is where an entity begins.
  Outcome find_next_word(RawGroup& group);

  [[nodiscard]] std::uint32_t line() const { return line_; }
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  bool next_line(std::string_view& text);
  Outcome value_of(int code, RawGroup& group);

  base::TextWindow window_;
  std::uint32_t line_ = 0;
  bool is_too_long_ = false;
  std::string fault_;
};

}  // namespace kerf::drawing::dxf
