#include "lang/gcode/code_library.hpp"

#include <algorithm>
#include <cassert>

namespace kerf::gcode {
namespace {

constexpr std::uint32_t kStraightPages = 8;  // before a thread is worth its while

}  // namespace

CodeLibrary::CodeLibrary(base::SourceSet& sources, const Settings& settings)
    : sources_(sources),
      compiler_(settings.lines_per_page),
      pages_(settings),
      ahead_(settings.lines_per_page) {}

CodeLibrary::~CodeLibrary() = default;

void CodeLibrary::add_file(base::FileId file) { add_programs(file, 0); }

void CodeLibrary::add_library_file(base::FileId file, std::uint32_t number_from_name) {
  add_programs(file, number_from_name);
}

void CodeLibrary::add_programs(base::FileId file, std::uint32_t number_from_name) {
  ProgramDirectory directory = read_directory(sources_[file], file);
  if (programs_.empty()) unread_ = directory.unread;
  for (ProgramEntry& entry : directory.programs) {
    if (entry.number == 0 && entry.name.empty()) entry.number = number_from_name;
    const auto code = static_cast<vm::CodeId>(programs_.size());
    if (entry.number != 0) by_number_.try_emplace(entry.number, code);
    if (!entry.name.empty()) by_name_.try_emplace(entry.name, code);
    const PageStart start{entry.begin, entry.line, entry.line_start};
    programs_.push_back({.entry = std::move(entry), .file = file, .starts = {start}});
  }
  findings_.insert(findings_.end(), directory.findings.begin(), directory.findings.end());
}

const ProgramEntry& CodeLibrary::entry(vm::CodeId code) const {
  return programs_[static_cast<std::size_t>(code)].entry;
}

std::optional<vm::CodeId> CodeLibrary::find(std::uint32_t number) const {
  const auto found = by_number_.find(number);
  return found == by_number_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<vm::CodeId> CodeLibrary::find(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<vm::CodeId> CodeLibrary::find_outside(base::FileId file, std::uint32_t number) const {
  for (std::size_t i = 0; i < programs_.size(); ++i) {
    if (number != 0 && programs_[i].file != file && programs_[i].entry.number == number)
      return vm::CodeId(i);
  }
  return std::nullopt;
}

GcodePage& CodeLibrary::page(vm::CodeId code, std::uint32_t number) {
  if (GcodePage* const kept = pages_.find(code, number)) return *kept;
  learn_starts(code, number);
  const bool seen_before = program(code).starts.size() > number + 1 || program(code).complete;
  return compile(code, number, seen_before);
}

// Compiles a page and notes where the next one begins.
GcodePage& CodeLibrary::compile(vm::CodeId code, std::uint32_t number, bool seen_before) {
  Program& target = program(code);
  GcodePage& page = pages_.make_room(code, number, seen_before);
  if (!ahead_.take(code, number, page)) {
    compiler_.compile(sources_[target.file], target.file, target.starts[number], target.entry.end,
                      names_, page);
    look_ahead(page);
  }
  if (page.last) {
    target.complete = true;
  } else if (target.starts.size() == number + 1) {
    target.starts.push_back({page.text_end, page.next_line, page.text_end});
  }
  return page;
}

// Whoever has come so far straight on will want the pages that follow.
void CodeLibrary::look_ahead(const GcodePage& page) {
  const bool straight = page.code == newest_code_ && page.number == newest_ + 1;
  straight_pages_ = straight ? straight_pages_ + 1 : 0;
  newest_code_ = page.code;
  newest_ = page.number;
  if (straight_pages_ < kStraightPages || page.last) return;
  straight_pages_ = 0;
  const Program& target = program(page.code);
  ahead_.begin({.file = &sources_[target.file],
                .id = target.file,
                .end = target.entry.end,
                .code = page.code,
                .number = page.number + 1,
                .start = {page.text_end, page.next_line, page.text_end}});
}

// A page that nobody has come near yet: the pages before it tell where it begins.
void CodeLibrary::learn_starts(vm::CodeId code, std::uint32_t number) {
  while (program(code).starts.size() <= number) {
    assert(!program(code).complete);
    const auto last = static_cast<std::uint32_t>(program(code).starts.size() - 1);
    compile(code, last, false);
  }
}

const std::vector<CodeLibrary::PlacedLabel>& CodeLibrary::labels_of(vm::CodeId code) {
  if (!program(code).labels) {
    std::vector<PlacedLabel> labels;
    for (std::uint32_t number = 0;; ++number) {
      const GcodePage& current = page(code, number);
      for (const Label& label : current.labels) {
        labels.push_back({label.number, {number, label.instruction}});
      }
      if (current.last) break;
    }
    std::sort(labels.begin(), labels.end());
    program(code).labels = std::move(labels);
  }
  return *program(code).labels;
}

// CTL-2: forward from the place of the jump to the end, then from the head.
std::optional<vm::Address> CodeLibrary::find_label(vm::CodeId code, vm::Address from,
                                                   std::uint32_t label) {
  const std::vector<PlacedLabel>& labels = labels_of(code);
  auto found = std::lower_bound(labels.begin(), labels.end(), PlacedLabel{label, from});
  if (found == labels.end() || found->number != label) {
    found = std::lower_bound(labels.begin(), labels.end(), PlacedLabel{label, {}});
  }
  if (found == labels.end() || found->number != label) return std::nullopt;
  return found->at;
}

// Marks are taken in the order of the text, each page of them once.
void CodeLibrary::match_next_page(vm::CodeId code) {
  const auto settle = [this, code](vm::Address head, const LoopEnding& ending) {
    program(code).endings[head] = ending;
  };
  if (!program(code).loops)
    program(code).loops = std::make_unique<LoopMatcher>(LoopMatcher::From::head, settle);
  const std::uint32_t number = program(code).matched_pages++;
  const GcodePage& current = page(code, number);
  LoopMatcher& loops = *program(code).loops;
  for (const LoopMark& mark : current.loop_marks) {
    const vm::Address at{number, mark.index};
    if (mark.is_end) {
      loops.take_end(mark.slot, at);
    } else {
      const bool asked = current.regions[mark.index].state == vm::Region::State::unresolved;
      loops.take_do(mark.slot, at, asked);
    }
  }
  if (current.last) loops.finish(vm::Region::State::open);
}

vm::Region CodeLibrary::resolve_region(vm::CodeId code, std::uint32_t page_number,
                                       std::uint32_t region) {
  vm::Region result = page(code, page_number).regions[region];
  if (result.state != vm::Region::State::unresolved) return result;
  const vm::Address head{page_number, region};
  while (!program(code).endings.contains(head)) match_next_page(code);
  const LoopEnding& ending = program(code).endings[head];
  result.state = ending.state;
  result.end = ending.end;
  return result;
}

void CodeLibrary::check(vm::CodeId code, base::Findings& found) {
  for (std::uint32_t number = 0; !found.over(); ++number) {
    check_page(code, number, found);
    if (page(code, number).last) return;
  }
}

// Jumps and loops are looked up by number, because a lookup may throw the page away.
void CodeLibrary::check_page(vm::CodeId code, std::uint32_t number, base::Findings& found) {
  using vm::Op;
  const auto add = [&](base::Diagnostic diagnostic) {
    diagnostic.program = name_of(program(code).entry);
    found.add(std::move(diagnostic));
  };
  const std::vector<vm::Instruction> instructions = page(code, number).instructions;
  for (std::uint32_t at = 0; at < instructions.size(); ++at) {
    const vm::Instruction& instruction = instructions[at];
    const auto place = [&] { return page(code, number).place_of(at); };
    if (instruction.op == Op::fail) {
      add(page(code, number).failures[instruction.n]);
    } else if (instruction.op == Op::jump_to_label && instruction.c != 0) {
      if (find_label(code, {number, at + 1}, instruction.n)) continue;
      base::Diagnostic missing =
          base::make_error(base::Code::label_not_found, place(),
                           "the program has no N" + std::to_string(instruction.n));
      missing.severity = base::Severity::warning;
      add(std::move(missing));
    } else if (instruction.op == Op::enter_region) {
      const vm::Region::State state = resolve_region(code, number, instruction.n).state;
      if (state == vm::Region::State::closed) continue;
      add(base::make_error(base::Code::missing_end, place()));
    }
  }
}

}  // namespace kerf::gcode
