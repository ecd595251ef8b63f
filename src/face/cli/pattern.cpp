#include <cstdio>

#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "drive/pattern/listing_reader.hpp"
#include "drive/pattern/reader.hpp"
#include "drive/pattern/writer.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/output_files.hpp"
#include "face/cli/pattern_files.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using base::OutputFile;

ExitStatus committed(OutputFile& file) {
  const auto done = file.commit();
  return done ? ExitStatus::well : fail(done.error());
}

base::Outcome<std::unique_ptr<OutputFile>> open_output(const PatternOptions& options) {
  if (is_same_file(options.output, options.file))
    return usage(options.output + ": is read by this command, and cannot be its output");
  return OutputFile::create(options.output.empty() ? "-" : options.output);
}

ExitStatus decode(const PatternOptions& options, const base::SourceSet& sources) {
  auto file = open_output(options);
  if (!file) return fail(file.error());
  drive::PatternReader reader(sources[kPatternFile], kPatternFile,
                              format_of(options, drive::ByteOrder::big));
  std::string line;
  for (;;) {
    const auto record = reader.next();
    if (!record) return report(record.error(), sources, options.diagnostics);
    if (!*record) return committed(**file);
    line.clear();
    drive::append_listing(line, **record);
    line += '\n';
    (*file)->write(line);
    if (!(*file)->good()) return committed(**file);
  }
}

// What a listing says, to its end. A pattern drives a machine: none is begun before all of the
// listing has been read once.
template <typename Take>
base::Result<void> read_listing(const base::SourceSet& sources, Take&& take) {
  drive::ListingReader reader(sources[kPatternFile], kPatternFile);
  for (;;) {
    const auto move = reader.next();
    if (!move) return base::unexpected(move.error());
    if (!*move || !take(**move)) return {};
  }
}

ExitStatus encode(const PatternOptions& options, const base::SourceSet& sources) {
  const auto read = read_listing(sources, [](const drive::ListedMove&) { return true; });
  if (!read) return report(read.error(), sources, options.diagnostics);
  auto file = open_output(options);
  if (!file) return fail(file.error());
  drive::PatternWriter writer(format_of(options, drive::ByteOrder::big).order, **file);
  const auto written = read_listing(sources, [&](const drive::ListedMove& move) {
    drive::each_record(move, [&](const auto& record) { writer.write(record); });
    return (*file)->good();
  });
  if (!written) return report(written.error(), sources, options.diagnostics);  // it has changed
  return committed(**file);
}

}  // namespace

drive::PatternFormat format_of(const PatternOptions& options, drive::ByteOrder usual) {
  using enum drive::ByteOrder;
  const auto order = options.byte_order.empty()       ? usual
                     : options.byte_order == "little" ? little
                                                      : big;
  return {order, options.lenient ? drive::AxisBits::lenient : drive::AxisBits::strict};
}

ExitStatus report(const base::Diagnostic& diagnostic, const base::SourceSet& sources,
                  DiagnosticFormat format) {
  const std::string text = format == DiagnosticFormat::json
                               ? output::diagnostic_json(diagnostic, sources)
                               : output::diagnostic_text(diagnostic, sources);
  std::fwrite(text.data(), 1, text.size(), stderr);
  return ExitStatus::findings;
}

ExitStatus pattern(const PatternOptions& options) {
  auto file = base::SourceFile::open(options.file, {.seconds = options.max_seconds});
  if (!file) return fail(file.error());
  base::SourceSet sources;
  sources.add(std::move(*file));
  switch (options.action) {
    case PatternOptions::Action::decode: return decode(options, sources);
    case PatternOptions::Action::encode: return encode(options, sources);
    case PatternOptions::Action::replay: return replay(options, sources);
  }
  return ExitStatus::fault;
}

}  // namespace kerf::cli
