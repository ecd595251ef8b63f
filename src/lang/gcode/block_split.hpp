#pragma once

#include <string_view>

namespace kerf::gcode {

/// Calls `take` with every block of a line: the text between semicolons outside of comments.
template <typename Take>
void split_blocks(std::string_view line, Take take) {
  std::size_t begin = 0;
  bool comment = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (comment) {
      comment = line[i] != ')';
    } else if (line[i] == '(') {
      comment = true;
    } else if (line[i] == ';') {
      take(line.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  take(line.substr(begin));
}

}  // namespace kerf::gcode
