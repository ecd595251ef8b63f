#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "face/cli/commands.hpp"
#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"

namespace kerf::cli {

/// An edits file: what it says, and where in it something is wrong.
class EditsSource {
 public:
  /// Failure (input): the file cannot be opened, or is too large.
  [[nodiscard]] static base::Outcome<EditsSource> read(const std::string& path);

  [[nodiscard]] const std::vector<features::Edit>& edits() const { return edits_; }
  /// EDIT_FILE: its text is no edits file.
  [[nodiscard]] const std::optional<base::Diagnostic>& fault() const { return fault_; }
  [[nodiscard]] const base::SourceSet& sources() const { return sources_; }
  /// Says on standard error what is wrong with an edit, at its place.
  void tell(const features::EditFault& fault, base::Severity severity,
            DiagnosticFormat format) const;

 private:
  [[nodiscard]] base::Place place(std::uint32_t line, std::uint32_t column) const;

  base::SourceSet sources_;
  base::FileId file_ = base::kNoFile;
  std::vector<std::uint64_t> line_starts_;
  std::vector<features::Edit> edits_;
  std::optional<base::Diagnostic> fault_;
};

}  // namespace kerf::cli
