#include "drawing/dxf/dxf_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drawing/dxf/internal/header.hpp"
#include "drawing/dxf/internal/record_reader.hpp"
#include "drawing/dxf/internal/run.hpp"

namespace kerf::drawing {
namespace dxf {
namespace {

using base::Code;
using base::Severity;

/// Takes the records of a file, section by section.
class Sections {
 public:
  explicit Sections(Canvas& canvas) : sheet_(canvas) {}

  /// False: nothing of interest follows.
  bool take(const Record& record);
  /// No record follows; `rest` is what there is of the last one. Tells what is missing.
  void end(const Record& rest, std::uint32_t line);
  [[nodiscard]] Canvas& canvas() { return sheet_.canvas; }

 private:
  void begin_section(const Record& record);
  void take_of_section(const Record& record);
  void take_of_blocks(const Record& record);
  void tell_fault(const Record& record);
  void begin_drawing();
  [[nodiscard]] bool has_use(const Record& record) const;

  Sheet sheet_;
  Header header_;
  std::string section_;  // empty: between two
  std::optional<Run> run_;
};

// Of what is wrong with other records no drawing takes harm.
bool Sections::has_use(const Record& record) const {
  if (section_ == "ENTITIES" || record.kind().empty()) return true;
  if (section_ == "BLOCKS") return record.kind() == "BLOCK";
  return section_ == "TABLES" && record.kind() == "LAYER";
}

void Sections::tell_fault(const Record& record) {
  if (record.kind().empty()) {
    canvas().find(Severity::error, Code::dxf_group, {base::kNoFile, record.fault().line, 1},
                  record.fault().what);
    return;
  }
  tell(record, sheet_, Severity::error, Code::dxf_group,
       fmt::format("is not read: {}", record.fault().what), record.fault().line);
}

void Sections::begin_drawing() {
  if (run_) return;
  choose_unit(header_, canvas());
  sheet_.blocks.weigh();
  const double scale = canvas().facts().scale_mm;
  run_.emplace(sheet_, Around{Affine::scaled(scale, scale)});
}

void Sections::begin_section(const Record& record) {
  section_ = sheet_.words(record.text(2));
  if (section_ == "HEADER") {
    header_ = header_of(record);
    canvas().facts().version = sheet_.words(header_.version);
    choose_words(header_, sheet_);
  }
  if (section_ == "ENTITIES") begin_drawing();
  if (section_ == "BLOCKS" && run_)
    canvas().ignore("BLOCKS", record.line(), "a second time, or behind what inserts them");
}

void Sections::take_of_blocks(const Record& record) {
  if (record.kind() == "BLOCK") return sheet_.blocks.begin(record);
  if (record.kind() != "ENDBLK") sheet_.blocks.add(record);
}

void Sections::take_of_section(const Record& record) {
  if (section_ == "ENTITIES") return run_->take(record);
  if (record.fault().line > 0 && has_use(record)) return tell_fault(record);
  if (section_ == "BLOCKS" && !run_) return take_of_blocks(record);
  if (section_ == "TABLES" && record.kind() == "LAYER") sheet_.layers.define(record);
}

bool Sections::take(const Record& record) {
  const std::string_view kind = record.kind();
  if (kind.empty()) {
    tell_fault(record);
  } else if (kind == "EOF") {
    return false;
  } else if (kind == "ENDSEC") {
    if (run_) run_->end();
    section_.clear();
  } else if (kind == "SECTION") {
    begin_section(record);
  } else if (!section_.empty()) {
    take_of_section(record);
  } else {
    tell(record, sheet_, Severity::error, Code::dxf_group, "stands in no section");
  }
  return !canvas().is_over();
}

void Sections::end(const Record& rest, std::uint32_t line) {
  const bool is_section = !section_.empty();
  if (run_ && rest.kind() == "ENDSEC") run_->end();
  if (rest.kind() == "EOF" && !is_section) return;
  std::string where = "the file ends";
  if (rest.kind() == "ENDSEC")
    where += fmt::format(" behind section {}", section_);
  else if (!rest.kind().empty() && rest.kind() != "EOF")
    where += fmt::format(" inside {}", described(rest, sheet_));
  const bool lacks_end = is_section && rest.kind() != "ENDSEC";
  const std::string missing =
      lacks_end ? fmt::format("the end of section {}", section_) : std::string("EOF");
  canvas().find(Severity::error, Code::dxf_truncated, {base::kNoFile, std::max(1U, line), 1},
                fmt::format("{}: {} is missing", where, missing));
}

bool begins_with(const base::SourceFile& file, std::string_view wanted) {
  std::array<char, 24> bytes{};
  const std::size_t count = file.read(0, bytes);
  return std::string_view(bytes.data(), count).starts_with(wanted);
}

/// Told, and not read.
bool is_of_another_kind(const base::SourceFile& file, Canvas& canvas) {
  const bool is_binary = begins_with(file, "AutoCAD Binary DXF");
  const bool is_dwg = begins_with(file, "AC1") || begins_with(file, "AC2.");
  if (is_binary) canvas.find(Severity::error, Code::dxf_binary, {base::kNoFile, 1, 1}, "");
  if (is_dwg) canvas.find(Severity::error, Code::dxf_dwg, {base::kNoFile, 1, 1}, "");
  return is_binary || is_dwg;
}

}  // namespace
}  // namespace dxf

void read_dxf(const base::SourceFile& file, base::FileId id, Canvas& canvas) {
  canvas.begin_file(id, "dxf");
  if (dxf::is_of_another_kind(file, canvas)) return;
  dxf::Sections sections(canvas);
  dxf::RecordReader reader(file, id);
  dxf::Record record;
  while (reader.next(record)) {
    if (!sections.take(record)) break;
  }
  if (!canvas.is_over()) sections.end(record, reader.line());
}

}  // namespace kerf::drawing
