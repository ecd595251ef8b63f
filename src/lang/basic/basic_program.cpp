#include "lang/basic/basic_program.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "lang/basic/builtins.hpp"
#include "lang/basic/line_compiler.hpp"

namespace kerf::basic {
namespace {

using vm::Op;

// Every label is there once: a jump within its page needs no search while it runs.
// `labels` has room from the page before: a program that runs straight on allocates nothing.
void resolve_jumps(BasicPage& page, std::vector<Label>& labels) {
  labels.assign(page.labels.begin(), page.labels.end());
  std::sort(labels.begin(), labels.end());
  for (vm::Instruction& instruction : page.instructions) {
    if (instruction.op != Op::jump_to_label) continue;
    const auto found = std::lower_bound(labels.begin(), labels.end(), Label{instruction.n, 0});
    if (found != labels.end() && found->number == instruction.n)
      instruction = {Op::jump, 0, 0, 0, found->instruction};
  }
}

}  // namespace

void BasicProgram::load(base::FileId file) {
  file_ = file;
  scan_ = scan(sources_[file], file, settings_.lines_per_page);
  compiled_.assign(scan_.pages.size(), false);
  pages_ = vm::PageStore<BasicPage>(settings_);  // not the code of the file before
  early_ = {};
}

std::optional<std::uint32_t> BasicProgram::find_variable(const std::string& capitals) const {
  const auto found = scan_.variables.find(capitals);
  return found == scan_.variables.end() ? std::nullopt : std::optional(found->second);
}

BasicPage& BasicProgram::page(vm::CodeId code, std::uint32_t number) {
  if (BasicPage* const kept = pages_.find(code, number)) return *kept;
  BasicPage& page = pages_.make_room(code, number, compiled_[number]);
  compiled_[number] = true;
  compile(number, page);
  return page;
}

void BasicProgram::compile(std::uint32_t number, BasicPage& page) {
  const PageStart& start = scan_.pages[number];
  const bool last = number + 1 == scan_.pages.size();
  const base::SourceFile& file = sources_[file_];
  page.clear();
  page.file = file_;
  page.text_begin = start.offset;
  page.builtins = builtin_table();
  window_.stand_at(file, file_, start.offset, last ? file.size() : scan_.pages[number + 1].offset);
  LineCompiler compiler(page, scan_, start, number == 0 ? std::nullopt : std::optional(early_));
  base::TextWindow::Line text;
  for (std::uint32_t line = start.line; window_.next(text); ++line) {
    const LineCompiler::Line place{text.text, line,
                                   static_cast<std::uint32_t>(text.offset - start.offset)};
    if (text.too_long) {
      compiler.fail_long_line(place);
    } else {
      compiler.compile(place);
    }
  }
  page.instructions.push_back({last ? Op::end_of_code : Op::next_page, 0, 0, 0, 0});
  page.spans.push_back({});
  resolve_jumps(page, sorted_labels_);
  if (number == 0) early_ = compiler.early();
}

// The last page that begins before the label.
std::uint32_t BasicProgram::page_of(std::uint32_t label) const {
  const bool named = label < scan_.label_lines.size();
  const auto begins_behind = [&](const PageStart& page) {
    return named ? page.line > scan_.label_lines[label] : scan_.label_behind(page.nexts) > label;
  };
  const auto behind =
      std::partition_point(scan_.pages.begin(), scan_.pages.end(),
                           [&](const PageStart& page) { return !begins_behind(page); });
  return static_cast<std::uint32_t>(behind - scan_.pages.begin()) - 1;
}

std::optional<vm::Address> BasicProgram::find_label(vm::CodeId code, vm::Address /*from*/,
                                                    std::uint32_t label) {
  const std::uint32_t number = page_of(label);
  for (const Label& candidate : page(code, number).labels) {
    if (candidate.number == label) return vm::Address{number, candidate.instruction};
  }
  return std::nullopt;
}

// No loop of the language is a region.
vm::Region BasicProgram::resolve_region(vm::CodeId /*code*/, std::uint32_t /*page*/,
                                        std::uint32_t /*region*/) {
  return {};
}

base::Result<std::unique_ptr<BasicPage>> BasicProgram::compile_condition(
    const std::string& text) const {
  auto page = std::make_unique<BasicPage>();
  page->builtins = builtin_table();
  Emitter emitter(*page, scan_, std::nullopt);
  emitter.begin_block(text.data());
  try {
    for (TokenStream names(text); !names.at_end();) {
      const Token name = names.take();
      if (name.type == TokenType::variable && !find_variable(name.text))
        throw SyntaxError{base::Code::basic_variable, name.begin, name.end,
                          "the program has no variable " + name.text};
    }
    TokenStream tokens(text);
    Expression expression(tokens, emitter);
    const std::uint8_t reg = expression.parse_into_next();
    if (!tokens.at_end()) tokens.fail(base::Code::basic_syntax, "nothing follows the condition");
    emitter.emit({Op::do_block, 0, 0, 0, reg});
  } catch (const SyntaxError& error) {
    const vm::Span span = vm::Span::between(error.begin, error.end, text.data());
    const base::Place place{.line = 1, .column = span.column, .length = span.length};
    return tl::unexpected(base::make_error(error.code, place, error.detail));
  }
  return page;
}

void BasicProgram::check(const std::string& program, base::Findings& into) {
  std::vector<base::Diagnostic> found = scan_.findings;
  std::set<std::pair<std::uint32_t, std::string>> told;  // lines and numbers
  for (const base::Diagnostic& finding : found) told.emplace(finding.place.line, finding.number);
  for (std::uint32_t number = 0; number < scan_.pages.size() && !into.over(); ++number) {
    for (const base::Diagnostic& failure : page(kCode, number).failures) {
      if (told.emplace(failure.place.line, failure.number).second) found.push_back(failure);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const base::Diagnostic& a, const base::Diagnostic& b) {
                     return a.place.line < b.place.line;
                   });
  for (base::Diagnostic& diagnostic : found) {
    diagnostic.program = program;
    into.add(std::move(diagnostic));
  }
}

}  // namespace kerf::basic
