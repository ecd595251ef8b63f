#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/source_file.hpp"

namespace kerf::cli {

/// Something that is wrong with a file, as text and as the object of `--format json`. Kept in these
/// forms because the places of diagnostics point into sources that go with the machine.
struct Finding {
  std::string file;  ///< its name, whatever bytes that has
  std::string text;  ///< a diagnostic with its source line and caret
  nlohmann::ordered_json object;
  bool counts = true;  ///< makes the exit status 1; false: --fail-on lets it pass
};

/// What is wrong with one of the files that are checked.
struct FileReport {
  std::string file;  ///< as the user wrote it
  std::vector<Finding> findings;
  bool budget_spent = false;             ///< its program did not come to an end
  std::optional<base::Failure> failure;  ///< why it could not be checked

  void add(const base::Diagnostic& diagnostic, const base::SourceSet& sources, bool counts = true);
  /// Whether any of it counts, or it could not be checked at all.
  [[nodiscard]] bool fails() const;
};

/// The reports in one of the formats `text`, `json` (one object a line), `sarif` (2.1.0), `junit`.
/// Every format is valid whatever bytes names and programs hold.
[[nodiscard]] std::string in_format(const std::vector<FileReport>& reports,
                                    const std::string& format);

}  // namespace kerf::cli
