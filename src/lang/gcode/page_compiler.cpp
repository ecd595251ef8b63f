#include "lang/gcode/page_compiler.hpp"

#include <algorithm>

#include "lang/gcode/block_parser.hpp"
#include "lang/gcode/block_split.hpp"
#include "lang/gcode/builtins.hpp"
#include "lang/gcode/loops.hpp"

namespace kerf::gcode {
namespace {

using vm::Op;

// A page of long lines ends early: its code is larger than its text.
constexpr std::uint64_t kMostPageBytes = 1 << 17;

// A GOTO whose label follows on its own page, or whose page is the whole program, becomes a jump.
// `labels` has room from the page before: a program that runs straight on allocates nothing.
void resolve_jumps(GcodePage& page, std::vector<Label>& labels) {
  const bool whole_program = page.number == 0 && page.last;
  labels.assign(page.labels.begin(), page.labels.end());
  std::sort(labels.begin(), labels.end());
  for (std::uint32_t at = 0; at < page.instructions.size(); ++at) {
    vm::Instruction& instruction = page.instructions[at];
    if (instruction.op != Op::jump_to_label || instruction.c == 0) continue;
    const auto first_from = [&](std::uint32_t from) -> const Label* {
      const auto found = std::lower_bound(labels.begin(), labels.end(), Label{instruction.n, from});
      return found == labels.end() || found->number != instruction.n ? nullptr : &*found;
    };
    const Label* found = first_from(at + 1);
    if (found == nullptr && whole_program) found = first_from(0);
    if (found != nullptr) instruction = {Op::jump, 0, 0, 0, found->instruction};
  }
}

void resolve_loops(GcodePage& page) {
  if (page.regions.empty()) return;
  const auto settle = [&](vm::Address head, const LoopEnding& ending) {
    vm::Region& region = page.regions[head.instruction];
    region.state = ending.state;
    region.end = ending.end;
  };
  LoopMatcher loops(page.number == 0 ? LoopMatcher::From::head : LoopMatcher::From::middle, settle);
  for (const LoopMark& mark : page.loop_marks) {
    const vm::Address at{page.number, mark.index};
    mark.is_end ? loops.take_end(mark.slot, at) : loops.take_do(mark.slot, at);
  }
  loops.finish(page.last ? vm::Region::State::open : vm::Region::State::unresolved);
}

}  // namespace

void PageCompiler::compile(const base::SourceFile& file, base::FileId id, const PageStart& start,
                           std::uint64_t end, NameTable& names, GcodePage& page) {
  page.clear();
  page.file = id;
  page.text_begin = start.offset;
  page.builtins = builtin_table();
  window_.stand_at(file, id, start.offset, end);
  BlockParser parser(page, names);
  std::uint32_t line_number = start.line;
  base::TextWindow::Line line;
  for (std::uint32_t lines = 0; lines < lines_per_page_; ++lines) {
    const bool full = window_.position() - start.offset >= kMostPageBytes;
    if (full || !window_.next(line)) break;
    const auto offset = static_cast<std::uint32_t>(line.offset - start.offset);
    const auto compile_block = [&](std::string_view block) {
      if (line.offset == 0 && block.data() == line.text.data())
        block = base::without_byte_order_mark(block);
      const auto within = static_cast<std::uint32_t>(block.data() - line.text.data());
      parser.compile({block, line.text.data(), line_number, offset + within, offset});
    };
    if (line.too_long) {
      parser.fail_long_line(line_number, offset);
    } else if (line.may_split) {
      split_blocks(line.text, compile_block);
    } else {
      compile_block(line.text);
    }
    line_number += line.complete ? 1 : 0;
  }
  page.text_end = window_.position();
  page.next_line = line_number;
  page.last = window_.at_end() || !window_.more();
  page.instructions.push_back({page.last ? Op::end_of_code : Op::next_page, 0, 0, 0, 0});
  page.spans.push_back({});
  resolve_jumps(page, sorted_labels_);
  resolve_loops(page);
}

}  // namespace kerf::gcode
