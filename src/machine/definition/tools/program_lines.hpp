#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "base/source_file.hpp"

namespace kerf::machine {

/// Hands on a program line by line, without its ends. A line is cut off behind 1000 bytes.
void each_line(const base::SourceFile& program, const std::function<void(std::string_view)>& take);

/// What a line of G-code says of tools and units. The line must outlive this.
class ProgramLine {
 public:
  /// `has_offset_in_t`: of the digits of T the last two are an offset, where there are more.
  ProgramLine(std::string_view line, bool has_offset_in_t);

  [[nodiscard]] const std::vector<std::string_view>& comments() const { return comments_; }
  [[nodiscard]] std::optional<int> tool() const { return tool_; }
  /// G20: true, G21: false.
  [[nodiscard]] std::optional<bool> inches() const { return inches_; }

 private:
  void take_word(char letter, std::string_view digits, bool has_offset_in_t);

  std::vector<std::string_view> comments_;
  std::optional<int> tool_;
  std::optional<bool> inches_;
};

}  // namespace kerf::machine
