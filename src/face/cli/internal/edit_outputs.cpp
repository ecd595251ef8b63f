#include "face/cli/internal/edit_outputs.hpp"

#include <filesystem>

#include "output/programs/unified_diff.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {

using base::Outcome;

Outcome<void> EditOutputs::open(const std::string& path, base::OutputFile*& file) {
  return files_.open(path, OutputFiles::Kind::record,
                     [&](base::OutputFile& opened) { file = &opened; });
}

Outcome<void> EditOutputs::open(const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) files_.keep_from(input);
  if (auto opened = open(options_.output, output_); !opened) return opened;
  // The program may only be replaced by what it has become.
  files_.keep_from(options_.run.program);
  if (auto opened = open(options_.diff, diff_); !opened) return opened;
  return open(options_.report, report_);
}

// Beside the others under its own name.
Outcome<void> EditOutputs::write_library(const ChangedText& text) {
  const auto name = std::filesystem::path(text.file).filename();
  const std::string path = (std::filesystem::path(options_.output_library) / name).string();
  return files_.open(path, OutputFiles::Kind::record,
                     [&](base::OutputFile& file) { file.write(text.after); });
}

Outcome<void> EditOutputs::write(const std::vector<ChangedText>& texts, const std::string& report) {
  if (output_ != nullptr) output_->write(texts.front().after);
  if (report_ != nullptr) report_->write(report);
  for (const ChangedText& text : texts) {
    if (diff_ != nullptr)
      diff_->write(output::unified_diff(text.file, text.before, text.stretches));
    const bool goes_beside = output_ != nullptr && !text.is_main && text.before != text.after;
    if (!goes_beside) continue;
    if (auto written = write_library(text); !written) return written;
  }
  return files_.commit(OutputFiles::Which::all);
}

std::string EditOutputs::written() const {
  std::string text;
  for (const std::string& path : files_.written())
    text += "  wrote " + output::printable(path) + "\n";
  return text;
}

}  // namespace kerf::cli
