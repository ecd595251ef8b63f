#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drive/pattern/writer.hpp"
#include "engraver/pattern_maker.hpp"
#include "engraver/pattern_plot.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/internal/post_output.hpp"
#include "face/cli/output_files.hpp"
#include "face/cli/ready_run.hpp"
#include "machine/run/batch_run.hpp"
#include "motion/axis_point.hpp"
#include "output/picture/path_plot.hpp"
#include "output/reports/coverage.hpp"
#include "output/reports/summary.hpp"

namespace kerf::cli {

/// The outputs of a run: their files, and what writes into them while it lasts.
class Outputs {
 public:
  /// Both must outlive the outputs, which the machine of the run must not run without.
  Outputs(const RunOptions& options, const ReadyRun& ready)
      : options_(options), ready_(ready), machine_(ready.machine()), post_(options, files_) {}

  /// What was found in the run's stock, for the summary.
  void tell_stock(output::CheckedStock checked) { stock_ = std::move(checked); }
  /// A file that is read: none of these may be written.
  void keep_from(const std::string& input) { files_.keep_from(input); }
  /// Opens what the options ask for and has the machine write into it. Failure (usage): an option
  /// does not fit its file's ending or the machine; (output): a file cannot be written.
  [[nodiscard]] base::Outcome<void> open();
  /// Completes the files of a run that is over. Failure (output): the first one that did not reach
  /// the disk; the others are written.
  [[nodiscard]] base::Outcome<void> commit();
  /// A demand on an output is not met, though the run ended well.
  [[nodiscard]] bool fails() const { return post_.fails(); }
  /// The files that commit() has written, for people.
  [[nodiscard]] const std::vector<std::string>& written() const { return files_.written(); }
  /// What else outputs have to say behind the run, for people: indented lines.
  [[nodiscard]] const std::string& remarks() const { return remarks_; }

 private:
  base::Outcome<void> open_prints();
  base::Outcome<void> open_motion();
  base::Outcome<void> open_points();
  base::Outcome<void> open_pulses();
  base::Outcome<void> open_pwm();
  base::Outcome<void> open_rows();
  base::Outcome<void> open_post();
  base::Outcome<void> open_pattern();
  base::Outcome<void> open_pattern_plot();
  base::Outcome<void> open_teach();
  base::Outcome<void> open_coverage();
  [[nodiscard]] base::Outcome<void> check_plot() const;
  [[nodiscard]] output::SummaryOfOutputs in_summary() const;
  [[nodiscard]] std::string title() const;
  [[nodiscard]] std::unique_ptr<output::PathPlot> make_plot() const;
  base::Outcome<void> open_plot();
  base::Outcome<void> open_summary();
  void add(std::unique_ptr<motion::MotionSink> sink);
  void add(std::unique_ptr<motion::AxisPointSink> sink);

  const RunOptions& options_;
  const ReadyRun& ready_;
  machine::BatchRun& machine_;
  OutputFiles files_;
  std::vector<std::unique_ptr<motion::MotionSink>> motion_sinks_;
  std::vector<std::unique_ptr<motion::AxisPointSink>> point_sinks_;
  std::unique_ptr<drive::PulseSink> pulses_;
  std::optional<machine::PatternMachine> motors_;
  std::unique_ptr<drive::PatternWriter> pattern_;
  std::unique_ptr<engraver::PatternPlot> pattern_plot_;
  engraver::PatternMaker* pattern_maker_ = nullptr;
  std::optional<engraver::PatternReport> pattern_report_;  // of a pattern that was written
  PostOutput post_;
  output::Coverage coverage_;
  std::string remarks_;
  std::string energy_;  // of a plot that has it, for the summary
  std::optional<output::CheckedStock> stock_;
};

}  // namespace kerf::cli
