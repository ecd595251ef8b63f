#include "lang/teach/record_reader.hpp"

#include "lang/vm/code_page.hpp"

namespace kerf::teach {

void RecordReader::stand_at(const base::SourceFile& file, base::FileId id,
                            const Position& position) {
  window_.stand_at(file, id, position.offset, file.size());
  file_ = id;
  position_ = position;
}

bool RecordReader::next(Line& line) {
  base::TextWindow::Line text;
  if (!window_.next(text)) return false;
  line.text = text.text;
  line.offset = text.offset;
  line.number = position_.line;
  line.words = Words(line.offset == 0 ? base::without_byte_order_mark(text.text) : text.text);
  line.record.reset();
  line.mistake.reset();
  if (text.too_long) {
    line.mistake = Mistake{base::Code::block_too_long, {}, {}};
    position_.sequence.pass_over();
  } else if (line.words.count() > 0) {
    judge(line);
    position_.last = {.file = file_, .line = line.number, .column = 1, .line_start = line.offset};
  }
  position_.offset = window_.position();
  ++position_.line;
  return true;
}

// Behind END any text is wrong, whatever it says.
void RecordReader::judge(Line& line) {
  Sequence& sequence = position_.sequence;
  if (sequence.ended()) {
    line.mistake = Sequence::behind_end();
    return;
  }
  auto parsed = parse_record(line.words);
  if (!parsed) {
    line.mistake = std::move(parsed.error());
    sequence.pass_over();
    return;
  }
  line.mistake = sequence.admit(*parsed);
  if (!line.mistake) line.record = *parsed;
}

base::Diagnostic RecordReader::diagnostic(const Line& line) const {
  const Mistake& mistake = *line.mistake;
  const bool whole = mistake.text.empty();
  const std::string_view text = whole && line.words.count() > 0 ? line.words[0] : mistake.text;
  const char* const begin = text.empty() ? line.text.data() : text.data();
  const vm::Span span = vm::Span::between(begin, begin + text.size(), line.text.data());
  const base::Place place{.file = file_,
                          .line = line.number,
                          .column = span.column,
                          .length = span.length,
                          .line_start = line.offset};
  return base::make_error(mistake.code, place, mistake.detail);
}

std::optional<base::Diagnostic> RecordReader::at_end() const {
  const auto mistake = position_.sequence.close();
  if (!mistake) return std::nullopt;
  const base::Place head{.file = file_, .line = 1, .column = 1};
  return base::make_error(mistake->code, position_.last.line != 0 ? position_.last : head,
                          mistake->detail);
}

}  // namespace kerf::teach
