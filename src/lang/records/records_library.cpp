#include "lang/records/records_library.hpp"

#include <utility>

#include "base/program_name.hpp"

namespace kerf::records {
namespace {

constexpr std::string_view kAround = " \t\r";
constexpr std::size_t kLongestName = 200;
constexpr std::size_t kLongestUnknown = 40;

// Of a text of the line that begins at `place`.
base::Place place_of(base::Place place, std::string_view line, std::string_view text) {
  place.column = static_cast<std::uint32_t>(text.data() - line.data() + 1);
  place.length = static_cast<std::uint32_t>(text.size());
  return place;
}

// The string of a member of a line, without its quotation marks; empty: it has none.
std::string text_in(const JsonLine& line, std::string_view name) {
  for (std::size_t i = 1; i < line.values().size(); i = line.values()[i].end) {
    const JsonValue& value = line.values()[i];
    if (value.name == name && value.kind == JsonValue::Kind::string) return json_text(value.text);
  }
  return {};
}

}  // namespace

RecordsLibrary::RecordsLibrary(const base::SourceSet& sources, FileNames& names,
                               const motion::AxisSetup& axes, const vm::PageSettings& settings)
    : StraightProgram(settings), sources_(sources), names_(names), parser_(axes) {}

void RecordsLibrary::rewind() {
  next_offset_ = 0;
  next_line_ = 1;
}

std::string RecordsLibrary::program_name() {
  const std::string first =
      loaded() ? sources_[file()].line_at(0, base::kLongestBlock) : std::string();
  JsonLine line;
  if (line.read(base::without_byte_order_mark(first)) ||
      line.values()[0].kind != JsonValue::Kind::object)
    return base::kUnnumberedProgram;
  for (const char* const name : {"source", "program"}) {
    std::string text = text_in(line, name);
    if (!text.empty() && text.size() <= kLongestName) return text;
  }
  return base::kUnnumberedProgram;
}

void RecordsLibrary::add(const base::Place& place, std::string_view text, Record& record,
                         RecordPage& page) {
  RecordBlock block{record.motion,
                    record.length,
                    std::string(record.unknown.substr(0, kLongestUnknown)),
                    {},
                    record.is_spiral,
                    std::move(record.radii)};
  if (!record.centre.empty()) {
    const base::Place centre = place_of(place, text, record.centre);
    block.centre = {centre.column & vm::Span::kMostColumn, centre.length & vm::Span::kMostLength};
  }
  block.motion.block.file = record.file.empty() ? file() : names_.id_of(json_text(record.file));
  if (block.motion.block.file != base::kNoFile) return page.add(place, std::move(block));
  page.fail(base::make_error(base::Code::motion_member, place_of(place, text, record.file),
                             "more than 1000 files are named"));
}

void RecordsLibrary::compile_line(const base::TextWindow::Line& line, RecordPage& page) {
  base::Place place{.file = file(), .line = next_line_++, .column = 1, .line_start = line.offset};
  if (line.too_long) return page.fail(base::make_error(base::Code::block_too_long, place));
  const std::string_view text =
      line.offset == 0 ? base::without_byte_order_mark(line.text) : line.text;
  const std::size_t first = text.find_first_not_of(kAround);
  if (first == std::string_view::npos) return;
  const std::size_t behind = text.find_last_not_of(kAround) + 1;
  place = place_of(place, line.text, text.substr(first, behind - first));
  auto record = parser_.parse(text);
  if (record) return add(place, line.text, *record, page);
  const Mistake& mistake = record.error();
  page.fail(
      base::make_error(mistake.code, place_of(place, line.text, mistake.text), mistake.detail));
}

void RecordsLibrary::compile(RecordPage& page) {
  page.begin(file(), next_offset_);
  const base::SourceFile& text = sources_[file()];
  window_.stand_at(text, file(), next_offset_, text.size());
  const auto full = [&](std::uint32_t lines) {
    return lines >= settings().lines_per_page ||
           window_.position() - page.text_begin >= RecordPage::kMostBytes;
  };
  base::TextWindow::Line line;
  for (std::uint32_t lines = 0; !page.last && !full(lines); ++lines) {
    page.last = !window_.next(line);
    if (!page.last) compile_line(line, page);
  }
  next_offset_ = window_.position();
  page.end();
}

}  // namespace kerf::records
