#include "lang/gcode/page_compiler.hpp"

#include <algorithm>
#include <cstring>

#include "lang/gcode/block_parser.hpp"
#include "lang/gcode/builtins.hpp"
#include "lang/gcode/loops.hpp"

namespace kerf::gcode {
namespace {

using vm::Op;

constexpr std::size_t kChunkBytes = 1 << 15;

struct LineEnd {
  std::size_t text = 0;  // where the line's text ends
  std::size_t next = 0;  // where the next line begins
};

// A line ends at LF, at CR…CR LF, or at a CR that no LF follows. `found` is false when the text
// ends first. An LF CR pair counts as LF: the stray CR is a blank of the next line.
bool find_line_end(std::string_view text, std::size_t from, LineEnd& end) {
  const void* const newline = std::memchr(text.data() + from, '\n', text.size() - from);
  const std::size_t stop =
      newline == nullptr
          ? text.size()
          : static_cast<std::size_t>(static_cast<const char*>(newline) - text.data());
  const void* const carriage = std::memchr(text.data() + from, '\r', stop - from);
  if (carriage == nullptr) {
    if (newline == nullptr) return false;
    end = {stop, stop + 1};
    return true;
  }
  const auto first = static_cast<std::size_t>(static_cast<const char*>(carriage) - text.data());
  std::size_t behind = first;
  while (behind < text.size() && text[behind] == '\r') ++behind;
  if (behind == text.size()) return false;  // an LF may still come
  if (text[behind] == '\n') {
    end = {first, behind + 1};
  } else if (first == from && from > 0 && text[from - 1] == '\n') {
    // LF CR: no line of its own
    LineEnd rest;
    if (!find_line_end(text, behind, rest)) return false;
    end = rest;
  } else {
    end = {first, first + 1};
  }
  return true;
}

// Calls `take` with every block of a line: the text between semicolons outside of comments.
template <typename Take>
void split_blocks(std::string_view line, Take take) {
  if (line.find(';') == std::string_view::npos) {
    take(line);
    return;
  }
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

// A GOTO whose label follows on its own page, or whose page is the whole program, becomes a jump.
void resolve_jumps(GcodePage& page) {
  const bool whole_program = page.number == 0 && page.last;
  for (std::uint32_t at = 0; at < page.instructions.size(); ++at) {
    vm::Instruction& instruction = page.instructions[at];
    if (instruction.op != Op::jump_to_label || instruction.c == 0) continue;
    const auto matches = [&](const Label& label) { return label.number == instruction.n; };
    const auto behind =
        std::find_if(page.labels.begin(), page.labels.end(),
                     [&](const Label& label) { return label.instruction > at && matches(label); });
    auto found = behind;
    if (found == page.labels.end() && whole_program) {
      found = std::find_if(page.labels.begin(), page.labels.end(), matches);
    }
    if (found != page.labels.end()) instruction = {Op::jump, 0, 0, 0, found->instruction};
  }
}

void resolve_loops(GcodePage& page) {
  if (page.regions.empty()) return;
  std::vector<PlacedLoopMark> marks;
  for (const LoopMark& mark : page.loop_marks) marks.push_back({mark, page.number});
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i].mark.is_end) continue;
    vm::Region& region = page.regions[marks[i].mark.index];
    const LoopEnding ending = find_end(marks, i, page.number == 0, page.last);
    region.state = ending.state;
    region.end = ending.end;
  }
}

}  // namespace

// Reads more text behind what is there. False at the program's end.
bool PageCompiler::fill(const base::SourceFile& file, std::uint64_t end) {
  const std::uint64_t at = text_at_ + text_.size();
  if (at >= end) return false;
  const std::size_t have = text_.size();
  text_.resize(have + std::min<std::uint64_t>(kChunkBytes, end - at));
  const std::size_t count = file.read(at, std::span(text_).subspan(have));
  text_.resize(have + count);
  return count > 0;
}

// Drops the text of a line that is too long, chunk by chunk, up to its end.
void PageCompiler::skip_long_line(const base::SourceFile& file, std::uint64_t end) {
  for (;;) {
    text_at_ += text_.size();
    text_.clear();
    position_ = 0;
    if (!fill(file, end)) return;
    const std::size_t stop = text_.find_first_of("\r\n");
    if (stop == std::string::npos) continue;
    LineEnd line_end;
    if (!find_line_end(text_, stop, line_end)) line_end = {stop, text_.size()};
    position_ = line_end.next;
    return;
  }
}

void PageCompiler::compile(const base::SourceFile& file, base::FileId id, const PageStart& start,
                           std::uint64_t end, NameTable& names, GcodePage& page) {
  page.clear();
  page.file = id;
  page.text_begin = start.offset;
  page.builtins = builtin_table();
  text_.clear();
  text_at_ = start.offset;
  position_ = 0;
  BlockParser parser(page, names);
  std::uint32_t line = start.line;
  bool more = true;
  std::uint32_t lines = 0;
  for (; lines < lines_per_page_; ++lines) {
    LineEnd line_end;
    while (!find_line_end(text_, position_, line_end) && more) {
      if (text_.size() - position_ > kLongestBlock) break;
      more = fill(file, end);
    }
    const bool complete = find_line_end(text_, position_, line_end);
    if (!complete) line_end = {text_.size(), text_.size()};
    if (!complete && !more && position_ == text_.size()) break;
    const std::string_view text =
        std::string_view(text_).substr(position_, line_end.text - position_);
    if (text.size() > kLongestBlock) {
      parser.fail_long_line(line, static_cast<std::uint32_t>(position_));
      if (!complete) {
        skip_long_line(file, end);
        ++line;
        break;
      }
    } else {
      split_blocks(text, [&](std::string_view block) {
        parser.compile({block, text.data(), line,
                        static_cast<std::uint32_t>(block.data() - text_.data()),
                        static_cast<std::uint32_t>(position_)});
      });
    }
    position_ = line_end.next;
    line += complete ? 1 : 0;
  }
  page.text_end = text_at_ + position_;
  page.next_line = line;
  page.last = page.text_end >= end || (!more && position_ >= text_.size());
  page.instructions.push_back({page.last ? Op::end_of_code : Op::next_page, 0, 0, 0, 0});
  page.spans.push_back({});
  resolve_jumps(page);
  resolve_loops(page);
}

}  // namespace kerf::gcode
