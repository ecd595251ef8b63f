#pragma once

#include <memory>
#include <string>

#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "stock/cutting/motion_cut.hpp"

namespace kerf::output {

/// Writes a row of CSV for every motion that moves (stock.md §8, `--blocks`): what it cut and how
/// fast. What is not known, or means nothing for the motion, is empty. Nothing is kept.
class StockRows final : public stock::TimedCutSink {
 public:
  /// Writes the header. The sources must outlive the rows.
  StockRows(std::unique_ptr<base::OutputFile> file, const base::SourceSet& sources);

  void take(const stock::TimedCut& cut) override;
  [[nodiscard]] base::Outcome<void> commit() { return file_->commit(); }

 private:
  void append_data(const stock::TimedCut& timed);
  void append(double value, bool is_known);
  void append_text(std::string_view text);

  std::unique_ptr<base::OutputFile> file_;
  const base::SourceSet& sources_;
  std::string row_;
};

}  // namespace kerf::output
