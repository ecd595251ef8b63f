#pragma once

#include <cstdint>

#include "base/source_file.hpp"
#include "base/text_window.hpp"
#include "lang/gcode/name_table.hpp"
#include "lang/gcode/page.hpp"

namespace kerf::gcode {

/// Where a page's text begins.
struct PageStart {
  std::uint64_t offset = 0;      ///< byte in the file
  std::uint32_t line = 1;        ///< line number there
  std::uint64_t line_start = 0;  ///< byte offset of that line
};

/// Compiles a program page by page. Holds the text of one page at a time, so its memory does not
/// depend on the length of the program.
class PageCompiler {
 public:
  explicit PageCompiler(std::uint32_t lines_per_page) : lines_per_page_(lines_per_page) {}

  /// Fills `page` from the text at `start` up to at most `end`. `page.code` and `page.number` are
  /// the caller's.
  void compile(const base::SourceFile& file, base::FileId id, const PageStart& start,
               std::uint64_t end, NameTable& names, GcodePage& page);

 private:
  std::uint32_t lines_per_page_;
  base::TextWindow window_;
  std::vector<Label> sorted_labels_;  // of the newest page
};

}  // namespace kerf::gcode
