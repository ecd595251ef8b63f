#include "face/cli/internal/undo.hpp"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "face/cli/failure.hpp"
#include "face/cli/internal/edit_outputs.hpp"
#include "face/cli/run_report.hpp"
#include "job/edit_undo.hpp"
#include "job/text_changes.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

constexpr std::uint64_t kLargestText = 1UL << 30;
constexpr std::uint64_t kLargestReport = 256UL << 20;

Outcome<std::vector<job::TextUndo>> report_of(const std::string& path) {
  auto text = base::read_whole(path, kLargestReport, "a report");
  if (!text) return tl::unexpected(text.error());
  auto undo = job::read_edit_report(*text);
  if (undo) return std::move(*undo);
  return tl::unexpected(base::Failure{base::Failure::Kind::input, path + ": " + undo.error()});
}

/// Where a text is now: one beside the program in a folder of --library, else where it was.
std::string path_of(const EditOptions& options, const job::TextUndo& text) {
  namespace fs = std::filesystem;
  if (text.is_main) return options.run.program;
  for (const std::string& folder : options.run.libraries) {
    const fs::path path = fs::path(folder) / fs::path(text.file).filename();
    std::error_code error;
    if (fs::is_regular_file(path, error)) return path.string();
  }
  return text.file;
}

/// EDIT_CHANGED_SINCE, at the line that is not what the edit has left.
base::Diagnostic changed_since(std::uint32_t line, const base::SourceFile& file,
                               const std::string& text) {
  base::Place place{.file = base::FileId{0}, .line = line, .column = line > 0 ? 1U : 0U};
  place.line_start = job::start_of_line(text, line);
  return base::make_error(base::Code::edit_changed_since, place,
                          line > 0 ? "" : "THE CHECKSUM OF " + file.name() + " DIFFERS");
}

/// A text without its edit; nothing: it is not what the edit has left, which has been told.
std::optional<ChangedText> without_edit(const EditOptions& options, const job::TextUndo& undo,
                                        const std::string& path, std::string text) {
  auto stretches = job::undo_of(undo, text);
  if (stretches) {
    std::string after = job::with_stretches(text, *stretches);
    return ChangedText{path, undo.is_main, std::move(text), std::move(after),
                       std::move(*stretches)};
  }
  base::SourceSet sources;
  sources.add(base::SourceFile::from_text(path, text));
  tell(changed_since(stretches.error().line, sources[base::FileId{0}], text), sources,
       options.run.diagnostics);
  return std::nullopt;
}

/// A file beside the program changes back, and nobody has said where it shall go.
bool lacks_folder(const EditOptions& options, const std::vector<job::TextUndo>& texts) {
  if (texts.size() < 2 || !options.output_library.empty()) return false;
  tell(base::make_error(base::Code::edit_other_file, {}, texts[1].file,
                        "--output-library names a folder for changed files"),
       {}, options.run.diagnostics);
  return true;
}

}  // namespace

ExitStatus undo_edit(const EditOptions& options) {
  EditOutputs outputs(options);
  if (auto opened = outputs.open({options.undo}); !opened) return fail(opened.error());
  auto undos = report_of(options.undo);
  if (!undos) return fail(undos.error());
  if (lacks_folder(options, *undos)) return ExitStatus::findings;
  std::vector<ChangedText> texts;
  for (const job::TextUndo& undo : *undos) {
    const std::string path = path_of(options, undo);
    auto text = base::read_whole(path, kLargestText, "a program");
    if (!text) return fail(text.error());
    auto changed = without_edit(options, undo, path, std::move(*text));
    if (!changed) return ExitStatus::findings;
    texts.push_back(std::move(*changed));
  }
  if (auto written = outputs.write(texts, {}); !written) return fail(written.error());
  if (options.run.diagnostics == DiagnosticFormat::json) return ExitStatus::well;
  const std::string text = "the edit is taken back\n" + outputs.written();
  std::fwrite(text.data(), 1, text.size(), stderr);
  return ExitStatus::well;
}

}  // namespace kerf::cli
