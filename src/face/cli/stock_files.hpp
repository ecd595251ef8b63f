#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "face/cli/commands.hpp"
#include "face/cli/output_files.hpp"
#include "job/other_part.hpp"
#include "job/stock_run.hpp"
#include "output/part/part_picture.hpp"
#include "output/reports/stock_facts.hpp"

namespace kerf::cli {

/// Adds the options of the files that show the part.
void add_stock_files(CLI::App& stock, StockFileOptions& options);

/// The files of the part: opened before the run, written behind it, and never half.
class StockFiles {
 public:
  /// The options outlive it.
  explicit StockFiles(const StockFileOptions& options) : options_(options) {}

  /// A file that is read: none of these may be written.
  void keep_from(const std::string& input) { files_.keep_from(input); }
  /// Failure (usage): an ending or a word that is none; (output): a file cannot be written.
  [[nodiscard]] base::Outcome<void> open(const job::StockJob& job);
  /// What the run has to keep for them.
  [[nodiscard]] bool needs_ways() const;
  /// Solids have deviations from the design of the job, else from the other part; null: there is
  /// none. Failure (usage): the part has no such file; (output): one did not reach the disk.
  [[nodiscard]] base::Outcome<void> write(const job::StockResult& result,
                                          const output::StockFacts& facts, const job::StockJob& job,
                                          const job::OtherPart* other);
  /// What else there is to say behind the run, for people: indented lines.
  [[nodiscard]] std::string remarks() const;

 private:
  [[nodiscard]] base::Outcome<void> write_part(const job::StockResult& result,
                                               const output::StockFacts& facts,
                                               const job::StockJob& job);
  [[nodiscard]] base::Outcome<void> write_solids(const job::StockResult& result,
                                                 const output::StockFacts& facts,
                                                 const job::StockJob& job,
                                                 const job::OtherPart* other);
  void write_profile(const job::StockResult& result);
  [[nodiscard]] output::PartScene scene_of(const job::StockResult& result,
                                           const output::StockFacts& facts,
                                           const job::StockJob& job) const;
  [[nodiscard]] output::plot::DisplayList picture(const job::StockResult& result,
                                                  const output::StockFacts& facts,
                                                  const job::StockJob& job) const;

  const StockFileOptions& options_;
  OutputFiles files_;
  std::optional<output::PartView> view_;
  base::OutputFile* stl_ = nullptr;
  base::OutputFile* glb_ = nullptr;
  base::OutputFile* three_mf_ = nullptr;
  base::OutputFile* picture_ = nullptr;
  base::OutputFile* profile_ = nullptr;
  base::OutputFile* save_ = nullptr;
  bool is_partial_ = false;  ///< what was to be saved is not the whole
};

}  // namespace kerf::cli
