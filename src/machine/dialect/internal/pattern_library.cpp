#include "machine/dialect/internal/pattern_library.hpp"

#include <algorithm>

#include "drive/pattern/split.hpp"

namespace kerf::machine {
namespace {

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
  if (move) {
    page.add(place, {*move, number});
  } else {
    page.fail(move.error());
  }
}

void PatternLibrary::compile(PatternPage& page) {
  page.begin(file(), next_offset_);
  const base::SourceFile& text = sources_[file()];
  window_.stand_at(text, file(), next_offset_, text.size());
  const auto full = [&](std::uint32_t lines) {
    return lines >= settings().lines_per_page ||
           window_.position() - page.text_begin >= PatternPage::kMostBytes;
  };
  base::TextWindow::Line line;
  for (std::uint32_t lines = 0; !page.last && !full(lines); ++lines) {
    page.last = !window_.next(line);
    if (!page.last) compile_line(line, next_line_++, page);
  }
  next_offset_ = window_.position();
  page.end();
}

}  // namespace kerf::machine
