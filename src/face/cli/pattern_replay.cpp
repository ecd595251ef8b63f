#include "engraver/pattern_replay.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <memory>

#include "base/decimal.hpp"
#include "control/core/memory.hpp"
#include "drive/pattern/writer.hpp"
#include "engraver/replay_plot.hpp"
#include "engraver/replay_summary.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/internal/pattern_play.hpp"
#include "face/cli/internal/post_output.hpp"
#include "face/cli/output_files.hpp"
#include "face/cli/pattern_files.hpp"
#include "face/cli/setting.hpp"
#include "output/picture/path_plot.hpp"
#include "output/records/laser_pulses.hpp"
#include "output/records/motion_json.hpp"
#include "output/records/row_csv.hpp"
#include "output/records/set_point_csv.hpp"
#include "output/writing/diagnostic_text.hpp"
#include "output/writing/title.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;
using base::OutputFile;

Outcome<machine::MachineDefinition> machine_of(const PatternOptions& options) {
  auto machine = machine::find_machine(options.machine);
  if (!machine) return machine;
  if (auto set = set_machine_keys(options.machine_keys, *machine); !set)
    return tl::unexpected(set.error());
  return machine;
}

/// A replay with its files.
class Replay {
 public:
  Replay(const PatternOptions& options, const base::SourceSet& sources,
         const machine::PatternMachine& machine)
      : options_(options),
        sources_(sources),
        definition_(machine.definition()),
        format_(format_of(options, definition_.pattern.byte_order)),
        file_(sources, definition_, format_),
        replay_(machine),
        post_(options, files_),
        no_tools_(definition_.parameters.n_offsets) {
    replay_.break_off_when([this] { return time_is_over(); });
  }

  Outcome<void> open();
  ExitStatus run();

  // For PatternPlay.
  [[nodiscard]] bool spent();
  base::Result<void> take(const drive::PatternRecord& record);
  base::Result<void> take(const drive::ListedLinked& linked);

 private:
  Outcome<void> open_output();
  Outcome<void> open_motion();
  Outcome<void> open_points();
  Outcome<void> open_pulses();
  Outcome<void> open_pwm();
  Outcome<void> open_rows();
  Outcome<void> open_post();
  Outcome<void> open_plot();
  Outcome<void> open_summary();
  base::Result<void> play();
  [[nodiscard]] bool time_is_over() const;
  [[nodiscard]] ExitStatus status() const;
  base::Result<void> followed(base::Result<void> made) const;
  base::Result<void> return_to_start();
  Outcome<void> commit();
  void tell() const;

  const PatternOptions& options_;
  const base::SourceSet& sources_;
  const machine::MachineDefinition& definition_;
  drive::PatternFormat format_;
  PatternPlay file_;
  engraver::PatternReplay replay_;
  engraver::ReplaySummary summary_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::optional<base::Diagnostic> notice_;  // why a budget ended the replay
  OutputFiles files_;
  PostOutput post_;
  std::unique_ptr<drive::PatternWriter> writer_;
  std::unique_ptr<output::MotionJson> motion_;
  std::unique_ptr<output::SetPointCsv> points_;
  std::unique_ptr<drive::PulseSink> pulses_;
  std::unique_ptr<output::LaserPulses> pwm_;
  std::optional<base::Diagnostic> laser_alarm_;
  control::Memory no_tools_;
  std::unique_ptr<output::RowCsv> rows_;
  std::unique_ptr<output::PathPlot> plot_;
  std::unique_ptr<engraver::ReplayPlot> way_to_plot_;
};

Outcome<void> Replay::open_output() {
  return files_.open(options_.output, OutputFiles::Kind::drives_a_machine, [&](OutputFile& file) {
    writer_ = std::make_unique<drive::PatternWriter>(format_.order, file);
  });
}

Outcome<void> Replay::open_motion() {
  return files_.open(options_.motion, OutputFiles::Kind::record, [&](OutputFile& file) {
    motion_ = std::make_unique<output::MotionJson>(definition_.axes, nullptr, file);
    replay_.add_sink(static_cast<motion::MotionSink&>(*motion_));
  });
}

Outcome<void> Replay::open_points() {
  return files_.open(options_.points, OutputFiles::Kind::record, [&](OutputFile& file) {
    points_ = std::make_unique<output::SetPointCsv>(definition_, file);
    replay_.add_sink(static_cast<motion::AxisPointSink&>(*points_));
  });
}

Outcome<void> Replay::open_pulses() {
  auto sink = open_pulse_file(files_, options_.pulses, definition_);
  if (!sink) return tl::unexpected(sink.error());
  pulses_ = std::move(*sink);
  if (pulses_) replay_.add_sink(*pulses_);
  return {};
}

Outcome<void> Replay::open_pwm() {
  const machine::LaserSettings& laser = definition_.drive.laser;
  if (!options_.pwm.empty() && !laser.fitted())
    return usage("--pwm " + options_.pwm + ": " + definition_.name + " has no laser");
  return files_.open(options_.pwm, OutputFiles::Kind::record, [&](OutputFile& file) {
    const auto fault = [this](const base::Diagnostic& alarm, const motion::Mark&) {
      if (!laser_alarm_) laser_alarm_ = alarm;
    };
    pwm_ = std::make_unique<output::LaserPulses>(laser, fault, file);
    replay_.add_sink(static_cast<motion::AxisPointSink&>(*pwm_));
    files_.when_over([this](OutputFile&) { pwm_->finish(); });
  });
}

Outcome<void> Replay::open_rows() {
  return files_.open(options_.rows, OutputFiles::Kind::record, [&](OutputFile& file) {
    rows_ = std::make_unique<output::RowCsv>(definition_.axes, no_tools_, file);
    replay_.add_sink(static_cast<motion::MotionSink&>(*rows_));
  });
}

Outcome<void> Replay::open_post() {
  auto opened = post_.open(definition_, output::file_title(options_.file));
  if (opened && post_.writer() != nullptr)
    replay_.add_sink(static_cast<motion::MotionSink&>(*post_.writer()));
  return opened;
}

Outcome<void> Replay::open_plot() {
  if (auto fits = check_picture("--plot", options_.plot); !fits) return fits;
  return files_.open(options_.plot, OutputFiles::Kind::record, [&](OutputFile&) {
    plot_ = std::make_unique<output::PathPlot>(
        definition_.axes, output::file_title(options_.file) + " on " + definition_.name);
    way_to_plot_ = std::make_unique<engraver::ReplayPlot>(replay_, *plot_);
    files_.when_over([this](OutputFile& into) {
      into.write(is_png(options_.plot) ? plot_->png() : plot_->svg());
    });
  });
}

Outcome<void> Replay::open_summary() {
  return files_.open(options_.summary, OutputFiles::Kind::record, [&](OutputFile&) {
    files_.when_over(
        [this](OutputFile& into) { into.write(engraver::replay_json(replay_, summary_)); });
  });
}

Outcome<void> Replay::open() {
  files_.keep_from(options_.file);
  constexpr std::array kSteps = {&Replay::open_output, &Replay::open_motion, &Replay::open_points,
                                 &Replay::open_pulses, &Replay::open_pwm,    &Replay::open_rows,
                                 &Replay::open_post,   &Replay::open_plot,   &Replay::open_summary};
  for (const auto step : kSteps) {
    if (auto opened = (this->*step)(); !opened) return opened;
  }
  return {};
}

base::Result<void> Replay::followed(base::Result<void> made) const {
  if (made && laser_alarm_) made = base::unexpected(*laser_alarm_);
  if (!made) file_.stand_here(made.error());
  return made;
}

base::Result<void> Replay::take(const drive::PatternRecord& record) {
  auto made = followed(replay_.take(record));
  if (made && writer_) writer_->write(record);
  return made;
}

base::Result<void> Replay::take(const drive::ListedLinked& linked) {
  if (!writer_) return followed(replay_.take(linked));
  return followed(base::unexpected(base::make_error(
      base::Code::pattern_text, {}, "L has no bytes, and --output writes a pattern")));
}

base::Result<void> Replay::return_to_start() {
  base::Result<void> made;
  for (const drive::FastMove& move : replay_.machine().way_to_start(replay_.counters())) {
    drive::each_record(move, [&](const drive::FastRecord& record) {
      if (made && !spent()) made = take(record);
    });
  }
  return made;
}

bool Replay::time_is_over() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  return options_.max_seconds > 0 && elapsed.count() > options_.max_seconds;
}

// Whether a budget allows no record here.
bool Replay::spent() {
  constexpr std::uint64_t kBetweenLooks = 16;  // at the clock, records
  if (notice_) return true;
  const bool enough =
      options_.max_motions > 0 && replay_.statistics().motions() >= options_.max_motions;
  const bool looks = replay_.totals().records() % kBetweenLooks == 0;
  const bool late = replay_.broken_off() || (looks && time_is_over());
  if (!enough && !late) return false;
  notice_ = base::make_error(
      base::Code::budget_spent, {},
      enough ? "the motions allowed are made"
             : base::number_text(options_.max_seconds) + " s of computing are over");
  notice_->severity = base::Severity::warning;
  file_.stand_here(*notice_);
  summary_.budget_spent = true;
  return true;
}

// Back to the start also from where an alarm has stopped it.
base::Result<void> Replay::play() {
  auto made = file_.run(*this);
  if (!options_.return_to_start) return made;
  if (notice_) {
    notice_->message += "; it does not return to the start";
    return made;
  }
  auto returned = return_to_start();
  return made ? returned : made;
}

Outcome<void> Replay::commit() {
  const bool at_end = !summary_.alarm && !notice_;
  if (at_end) post_.judge();
  return files_.commit(at_end || options_.keep_partial ? OutputFiles::Which::all
                                                       : OutputFiles::Which::records_only);
}

ExitStatus Replay::status() const {
  if (summary_.alarm) return ExitStatus::findings;
  if (notice_) return ExitStatus::budget;
  return post_.fails() ? ExitStatus::findings : ExitStatus::well;
}

void Replay::tell() const {
  if (summary_.alarm) report(*summary_.alarm, sources_, options_.diagnostics);
  for (const auto& [sentence, record] : replay_.beyond_travel()) {
    base::Diagnostic warning =
        base::make_error(base::Code::joint_limit, {.file = kPatternFile},
                         "record " + std::to_string(record) + ": " + sentence);
    warning.severity = base::Severity::warning;
    if (file_.has_bytes()) warning.offset = (record - 1) * drive::kRecordBytes;
    report(warning, sources_, options_.diagnostics);
  }
  if (notice_) report(*notice_, sources_, options_.diagnostics);
}

ExitStatus Replay::run() {
  auto played = play();
  replay_.finish();
  summary_.file = options_.file;
  if (!played) summary_.alarm = std::move(played.error());
  if (auto committed = commit(); !committed) return fail(committed.error());
  tell();
  if (options_.diagnostics == DiagnosticFormat::text) {
    std::string text = engraver::replay_text(replay_, summary_);
    for (const std::string& path : files_.written())
      text += "  wrote " + output::printable(path) + "\n";
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
  return status();
}

}  // namespace

ExitStatus replay(const PatternOptions& options, const base::SourceSet& sources) {
  const auto definition = machine_of(options);
  if (!definition) return fail(definition.error());
  const auto machine = machine::PatternMachine::of(*definition);
  if (!machine) return fail(machine.error());
  Replay replay(options, sources, *machine);
  if (auto opened = replay.open(); !opened) return fail(opened.error());
  return replay.run();
}

}  // namespace kerf::cli
