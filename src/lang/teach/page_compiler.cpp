#include "lang/teach/page_compiler.hpp"

namespace kerf::teach {
namespace {

using vm::Op;

// A page of long lines ends early.
constexpr std::uint64_t kMostPageBytes = 1 << 17;

std::uint32_t offset_in(const TeachPage& page, std::uint64_t offset) {
  return static_cast<std::uint32_t>(offset - page.text_begin);
}

void mark(TeachPage& page, std::uint32_t line, std::uint64_t line_start, std::uint32_t column,
          std::uint32_t length) {
  const std::uint32_t line_offset = offset_in(page, line_start);
  page.marks.push_back({static_cast<std::uint32_t>(page.instructions.size()), line,
                        line_offset + column - 1, line_offset, length, 0});
}

void emit(TeachPage& page, Op op, std::uint32_t n, vm::Span span) {
  page.instructions.push_back({op, 0, 0, 0, n});
  page.spans.push_back(span);
}

}  // namespace

void PageCompiler::add_block(TeachPage& page) {
  Block block{*line_.record, {}};
  const auto words = line_.words.kept();
  for (std::size_t i = 0; i < std::min(words.size(), block.words.size()); ++i)
    block.words[i] =
        vm::Span::between(words[i].data(), words[i].data() + words[i].size(), line_.text.data());
  const char* const behind = words.back().data() + words.back().size();
  mark(page, line_.number, line_.offset, block.words[0].column,
       static_cast<std::uint32_t>(behind - words[0].data()));
  emit(page, Op::do_block, static_cast<std::uint32_t>(page.blocks.size()), block.words[0]);
  page.blocks.push_back(block);
}

void PageCompiler::add_failure(const base::Diagnostic& mistake, TeachPage& page) {
  const base::Place& place = mistake.place;
  mark(page, place.line, place.line_start, place.column, place.length);
  emit(page, Op::fail, static_cast<std::uint32_t>(page.failures.size()),
       {place.column & vm::Span::kMostColumn, place.length & vm::Span::kMostLength});
  page.failures.push_back(mistake);
}

// END waits: it is executed if nothing but comments follows.
void PageCompiler::compile_end(TeachPage& page) {
  const std::uint32_t number = line_.number;
  const std::uint64_t offset = line_.offset;
  const std::string_view word = line_.words[0];
  const vm::Span span =
      vm::Span::between(word.data(), word.data() + word.size(), line_.text.data());
  while (reader_.next(line_)) {
    if (!line_.mistake) continue;
    add_failure(reader_.diagnostic(line_), page);
    return;
  }
  mark(page, number, offset, span.column, span.length);
  emit(page, Op::do_block, static_cast<std::uint32_t>(page.blocks.size()), span);
  page.blocks.push_back({End{}, {span}});
}

// False behind the last line.
bool PageCompiler::compile_next(TeachPage& page) {
  if (!reader_.next(line_)) return false;
  if (line_.record && std::holds_alternative<End>(*line_.record)) {
    compile_end(page);
    return false;
  }
  if (line_.mistake) add_failure(reader_.diagnostic(line_), page);
  if (line_.record) add_block(page);
  return true;
}

void PageCompiler::compile(const base::SourceFile& file, base::FileId id,
                           const RecordReader::Position& start, TeachPage& page) {
  page.clear();
  page.file = id;
  page.text_begin = start.offset;
  reader_.stand_at(file, id, start);
  const auto full = [&](std::uint32_t lines) {
    return lines >= lines_per_page_ || reader_.position().offset - start.offset >= kMostPageBytes;
  };
  for (std::uint32_t lines = 0; !page.last && !full(lines); ++lines)
    page.last = !compile_next(page);
  page.next = reader_.position();
  if (page.last) {
    if (const auto missing = reader_.at_end()) add_failure(*missing, page);
  }
  emit(page, page.last ? Op::end_of_code : Op::next_page, 0, {});
}

}  // namespace kerf::teach
