#include "face/cli/internal/edits_source.hpp"

#include "face/cli/run_report.hpp"
#include "job/edits_file.hpp"

namespace kerf::cli {
namespace {

constexpr std::uint64_t kLargestEdits = 64UL << 20;  // bytes

}  // namespace

base::Outcome<EditsSource> EditsSource::read(const std::string& path) {
  auto text = base::read_whole(path, kLargestEdits, "an edits file");
  if (!text) return tl::unexpected(text.error());
  EditsSource source;
  source.line_starts_ = {0};
  for (std::size_t i = 0; i < text->size(); ++i) {
    if ((*text)[i] == '\n') source.line_starts_.push_back(i + 1);
  }
  auto edits = job::read_edits(*text);
  source.file_ = source.sources_.add(base::SourceFile::from_text(path, std::move(*text)));
  if (edits) {
    source.edits_ = std::move(*edits);
  } else {
    source.fault_ = base::make_error(base::Code::edit_file,
                                     source.place(edits.error().line, edits.error().column),
                                     edits.error().sentence);
  }
  return source;
}

base::Place EditsSource::place(std::uint32_t line, std::uint32_t column) const {
  base::Place place{.file = file_, .line = line, .column = column};
  if (line > 0 && line <= line_starts_.size()) place.line_start = line_starts_[line - 1];
  return place;
}

void EditsSource::tell(const features::EditFault& fault, base::Severity severity,
                       DiagnosticFormat format) const {
  base::Place at{.file = file_};
  if (fault.edit < edits_.size()) at = place(edits_[fault.edit].line, edits_[fault.edit].column);
  base::Diagnostic diagnostic = base::make_error(fault.code, at, {}, fault.hint);
  diagnostic.severity = severity;
  if (!fault.sentence.empty()) diagnostic.message = fault.sentence;
  cli::tell(diagnostic, sources_, format);
}

}  // namespace kerf::cli
