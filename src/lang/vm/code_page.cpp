#include "lang/vm/code_page.hpp"

#include <algorithm>

namespace kerf::vm {

const BlockMark* CodePage::mark_of(std::uint32_t instruction) const {
  const auto behind = std::upper_bound(
      marks.begin(), marks.end(), instruction,
      [](std::uint32_t wanted, const BlockMark& mark) { return wanted < mark.instruction; });
  return behind == marks.begin() ? nullptr : &*std::prev(behind);
}

base::Place CodePage::place_of(std::uint32_t instruction) const {
  const BlockMark* const mark = mark_of(instruction);
  if (mark == nullptr || instruction >= spans.size()) return {.file = file};
  const Span span = spans[instruction];
  const std::uint32_t block_column = mark->offset - mark->line_offset + 1;
  return {.file = file,
          .line = mark->line,
          .column = span.column != 0 ? span.column : block_column,
          .length = span.length,
          .line_start = text_begin + mark->line_offset};
}

void CodePage::clear_code() {
  instructions.clear();
  spans.clear();
  constants.clear();
  regions.clear();
  failures.clear();
  marks.clear();
}

std::size_t CodePage::bytes_of_code() const {
  return bytes_of(instructions) + bytes_of(spans) + bytes_of(constants) + bytes_of(regions) +
         bytes_of(failures) + bytes_of(marks);
}

}  // namespace kerf::vm
