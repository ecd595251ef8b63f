#pragma once

#include <string>
#include <vector>

#include "base/text_stretch.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/output_files.hpp"

namespace kerf::cli {

/// A text of a program, and what takes the place of which of its stretches.
struct ChangedText {
  std::string file{};  ///< as the user wrote it
  bool is_main = true;
  std::string before{};
  std::string after{};
  std::vector<base::TextStretch> stretches{};
};

/// The files that `kerf edit` writes: opened before the work, so that one that cannot be written is
/// told at once; committed only when all held.
class EditOutputs {
 public:
  explicit EditOutputs(const EditOptions& options) : options_(options) {}

  /// `inputs`: files that are read, besides the program, which may be replaced.
  [[nodiscard]] base::Outcome<void> open(const std::vector<std::string>& inputs);
  /// The main text is the first one. `report`: JSON. Failure (output).
  [[nodiscard]] base::Outcome<void> write(const std::vector<ChangedText>& texts,
                                          const std::string& report);
  /// A sentence for each file that was written, for people.
  [[nodiscard]] std::string written() const;

 private:
  [[nodiscard]] base::Outcome<void> open(const std::string& path, base::OutputFile*& file);
  [[nodiscard]] base::Outcome<void> write_library(const ChangedText& text);

  const EditOptions& options_;
  OutputFiles files_;
  base::OutputFile* output_ = nullptr;  // null: not asked for
  base::OutputFile* diff_ = nullptr;
  base::OutputFile* report_ = nullptr;
};

}  // namespace kerf::cli
