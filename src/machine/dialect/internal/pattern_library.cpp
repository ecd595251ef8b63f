#include "machine/dialect/internal/pattern_library.hpp"

#include <algorithm>

#include "drive/pattern/split.hpp"

namespace kerf::machine {
namespace {

using vm::Op;

// A page of long lines ends early.
constexpr std::uint64_t kMostPageBytes = 1 << 17;

void mark(PatternPage& page, const base::Place& place) {
  const auto line_offset = static_cast<std::uint32_t>(place.line_start - page.text_begin);
  page.marks.push_back({static_cast<std::uint32_t>(page.instructions.size()), place.line,
                        line_offset + place.column - 1, line_offset, place.length, 0});
}

void emit(PatternPage& page, Op op, std::size_t n, vm::Span span) {
  page.instructions.push_back({op, 0, 0, 0, static_cast<std::uint32_t>(n)});
  page.spans.push_back(span);
}

// Records that a line makes; a cut that is split may have one more for its wheel.
std::int64_t records_of(const drive::ListedMove& move) {
  const auto parts = [](std::int64_t size, std::int64_t most) { return (size + most - 1) / most; };
  if (const auto* const fast = std::get_if<drive::ListedFast>(&move))
    return parts(fast->count.size, drive::kMostFastPulses);
  const auto* const slow = std::get_if<drive::ListedSlow>(&move);
  if (slow == nullptr) return 0;
  const auto& [wheel, forearm, upper_arm] = slow->counts;
  return parts(wheel.size, drive::kMostTripletPulses) +
         parts(std::max(forearm.size, upper_arm.size), drive::kMostTripletPulses);
}

base::Result<drive::ListedMove> read_line(std::string_view text, bool too_long,
                                          const base::Place& place) {
  if (too_long) {
    return base::unexpected(
        base::make_error(base::Code::pattern_text, place, "the line has no end for too long"));
  }
  auto move = drive::parse_listing(text, place);
  if (!move || records_of(*move) <= PatternLibrary::kMostRecords) return move;
  return base::unexpected(base::make_error(
      base::Code::pattern_text, place,
      "the line is " + std::to_string(records_of(*move)) + " records, and at most " +
          std::to_string(PatternLibrary::kMostRecords) + " are made in one go"));
}

}  // namespace

void PatternPage::clear() {
  clear_code();
  blocks.clear();
  last = false;
}

std::size_t PatternPage::bytes() const { return bytes_of_code() + bytes_of(blocks); }

PatternLibrary::PatternLibrary(const base::SourceSet& sources, const vm::PageSettings& settings)
    : StraightProgram(settings), sources_(sources) {}

void PatternLibrary::rewind() {
  next_offset_ = 0;
  next_line_ = 1;
}

void PatternLibrary::compile_line(const base::TextWindow::Line& line, std::uint32_t number,
                                  PatternPage& page) {
  const std::string_view text =
      line.offset == 0 ? base::without_byte_order_mark(line.text) : line.text;
  const std::size_t first = std::min(line.text.find_first_not_of(" \t"), line.text.size());
  const std::size_t end = line.text.find_last_not_of(" \t", line.text.find('#') - 1) + 1;
  base::Place place{.file = file(),
                    .line = number,
                    .column = static_cast<std::uint32_t>(first + 1),
                    .line_start = line.offset};
  place.length = static_cast<std::uint32_t>(end > first ? end - first : 0);
  const auto move = read_line(text, line.too_long, place);
  if (move && std::holds_alternative<std::monostate>(*move)) return;
  const base::Place& at = move ? place : move.error().place;
  const vm::Span span{at.column & vm::Span::kMostColumn, at.length & vm::Span::kMostLength};
  mark(page, at);
  if (move) {
    emit(page, Op::do_block, page.blocks.size(), span);
    page.blocks.push_back({*move, number});
  } else {
    emit(page, Op::fail, page.failures.size(), span);
    page.failures.push_back(move.error());
  }
}

void PatternLibrary::compile(PatternPage& page) {
  page.clear();
  page.file = file();
  page.text_begin = next_offset_;
  const base::SourceFile& text = sources_[file()];
  window_.stand_at(text, file(), next_offset_, text.size());
  const auto full = [&](std::uint32_t lines) {
    return lines >= settings().lines_per_page ||
           window_.position() - page.text_begin >= kMostPageBytes;
  };
  base::TextWindow::Line line;
  for (std::uint32_t lines = 0; !page.last && !full(lines); ++lines) {
    page.last = !window_.next(line);
    if (!page.last) compile_line(line, next_line_++, page);
  }
  next_offset_ = window_.position();
  emit(page, page.last ? Op::end_of_code : Op::next_page, 0, {});
}

}  // namespace kerf::machine
