#pragma once

#include <utility>

#include "lang/vm/code_page.hpp"

namespace kerf::vm {

/// The code of a stretch of a file of which each line is a block, a mistake or nothing: `do_block`
/// for a block, `fail` for a mistake.
template <typename Block>
struct LinePage : CodePage {
  /// A page of long lines ends early.
  static constexpr std::uint64_t kMostBytes = 1 << 17;

  std::vector<Block> blocks;
  bool last = false;  ///< the file ends with this page

  /// Begins with the byte of that offset.
  void begin(base::FileId of, std::uint64_t offset) {
    clear_code();
    blocks.clear();
    last = false;
    file = of;
    text_begin = offset;
  }
  /// A block, and the text that it is.
  void add(const base::Place& place, Block block) {
    put(place, Op::do_block, blocks.size());
    blocks.push_back(std::move(block));
  }
  void fail(const base::Diagnostic& mistake) {
    put(mistake.place, Op::fail, failures.size());
    failures.push_back(mistake);
  }
  void end() { emit(last ? Op::end_of_code : Op::next_page, 0, {}); }
  /// Bytes that the page occupies, for the budget of those who keep pages.
  [[nodiscard]] std::size_t bytes() const { return bytes_of_code() + bytes_of(blocks); }

 private:
  void put(const base::Place& place, Op op, std::size_t n) {
    const auto line_offset = static_cast<std::uint32_t>(place.line_start - text_begin);
    marks.push_back({static_cast<std::uint32_t>(instructions.size()), place.line,
                     line_offset + place.column - 1, line_offset, place.length, 0});
    emit(op, n, {place.column & Span::kMostColumn, place.length & Span::kMostLength});
  }
  void emit(Op op, std::size_t n, Span span) {
    instructions.push_back({op, 0, 0, 0, static_cast<std::uint32_t>(n)});
    spans.push_back(span);
  }
};

}  // namespace kerf::vm
