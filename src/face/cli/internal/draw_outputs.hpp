#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drive/pattern/writer.hpp"
#include "engraver/pattern_maker.hpp"
#include "engraver/pattern_report.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/output_files.hpp"
#include "job/drawing/draw_run.hpp"
#include "output/drawings/draw_facts.hpp"
#include "output/picture/path_plot.hpp"

namespace kerf::cli {

/// The files that `kerf draw` writes.
class DrawOutputs {
 public:
  /// All must outlive this.
  DrawOutputs(const DrawOptions& options, const job::DrawOrder& order,
              const std::shared_ptr<const job::DrawnPlan>& plan);

  /// Failure (usage): an ending that names no language, a language that the machine does not have;
  /// (output): a file cannot be written.
  [[nodiscard]] base::Outcome<void> open();
  [[nodiscard]] const job::DrawWatchers& watchers() const { return watchers_; }
  /// Completes the files; programs only where `programs` says so. Puts the targets into the facts.
  [[nodiscard]] base::Outcome<void> commit(output::DrawFacts& facts, bool programs);

 private:
  base::Outcome<void> open_target(const std::string& path);
  base::Outcome<void> open_gcode(const std::string& path);
  base::Outcome<void> open_basic(const std::string& path);
  base::Outcome<void> open_taught(const std::string& path);
  base::Outcome<void> open_motions(const std::string& path);
  base::Outcome<void> open_pattern(const std::string& path);
  base::Outcome<void> open_contours();
  base::Outcome<void> open_picture();
  [[nodiscard]] std::string report() const;
  void add(std::unique_ptr<motion::MotionSink> sink);
  /// Calls `say` where a contour begins, with what text targets tell of it.
  void comment_by(std::function<void(const std::string&, std::uint32_t)> say);

  const DrawOptions& options_;
  const job::DrawOrder& order_;
  const std::shared_ptr<const job::DrawnPlan>& plan_;
  OutputFiles files_;
  job::DrawWatchers watchers_;
  std::vector<std::unique_ptr<motion::MotionSink>> sinks_;
  std::vector<output::DrawTarget> targets_;
  std::vector<std::function<void(output::DrawTarget&)>> targets_over_;
  std::unique_ptr<output::PathPlot> plot_;
  std::optional<machine::PatternMachine> motors_;
  std::unique_ptr<drive::PatternWriter> pattern_;
  std::unique_ptr<engraver::PatternMaker> maker_;
  engraver::PatternReport report_of_pattern_;
  output::DrawFacts* facts_ = nullptr;  // behind the run
};

}  // namespace kerf::cli
