#include "output/pattern_replay.hpp"

#include <array>
#include <cstdio>
#include <functional>
#include <memory>

#include "base/decimal.hpp"
#include "base/output_file.hpp"
#include "cli/failure.hpp"
#include "cli/machine_setup.hpp"
#include "cli/pattern_files.hpp"
#include "drive/pattern/reader.hpp"
#include "drive/pattern/writer.hpp"
#include "drive/pulse_csv.hpp"
#include "drive/pulse_vcd.hpp"
#include "output/diagnostic_text.hpp"
#include "output/motion_json.hpp"
#include "output/path_plot.hpp"
#include "output/replay_plot.hpp"
#include "output/replay_summary.hpp"
#include "output/set_point_csv.hpp"

namespace kerf::cli {
namespace {

using base::Failure;
using base::Outcome;
using base::OutputFile;

tl::unexpected<Failure> usage(const std::string& message) {
  return tl::unexpected(Failure{Failure::Kind::usage, message});
}

bool is_png(const std::string& path) { return path.ends_with(".png"); }

Outcome<machine::MachineDefinition> machine_of(const PatternOptions& options) {
  auto machine = machine::find_machine(options.machine);
  if (!machine) return machine;
  for (const std::string& text : options.machine_keys) {
    auto setting = split_setting(text, "--machine-set");
    if (!setting) return tl::unexpected(setting.error());
    if (auto set = machine->set(setting->key, setting->value); !set)
      return tl::unexpected(set.error());
  }
  return machine;
}

/// A replay with its files: opened before it, so that one that cannot be written is told at once,
/// committed behind it.
class Replay {
 public:
  Replay(const PatternOptions& options, const base::SourceSet& sources,
         const output::PatternMachine& machine)
      : options_(options),
        sources_(sources),
        definition_(machine.definition()),
        format_(format_of(options, definition_.pattern.byte_order)),
        replay_(machine) {}

  Outcome<void> open();
  ExitStatus run();

 private:
  enum class Kind : std::uint8_t { record, drives_a_machine };
  struct Output {
    Kind kind = Kind::record;
    std::unique_ptr<OutputFile> file;
    std::function<void(OutputFile&)> finish;
  };

  // Null: the option was not given.
  Outcome<OutputFile*> open_file(const std::string& path, Kind kind = Kind::record);
  Outcome<void> open_output();
  Outcome<void> open_motion();
  Outcome<void> open_points();
  Outcome<void> open_pulses();
  Outcome<void> open_plot();
  Outcome<void> open_summary();
  base::Result<void> play();
  base::Result<void> take(const drive::PatternRecord& record, std::uint64_t offset);
  base::Result<void> return_to_start(std::uint64_t offset);
  Outcome<void> commit();
  void tell(const std::optional<base::Diagnostic>& alarm) const;
  void warn() const;

  const PatternOptions& options_;
  const base::SourceSet& sources_;
  const machine::MachineDefinition& definition_;
  drive::PatternFormat format_;
  output::PatternReplay replay_;
  output::ReplaySummary summary_;
  std::vector<Output> outputs_;
  std::unique_ptr<drive::PatternWriter> writer_;
  std::unique_ptr<output::MotionJson> motion_;
  std::unique_ptr<output::SetPointCsv> points_;
  std::unique_ptr<drive::PulseSink> pulses_;
  std::unique_ptr<output::PathPlot> plot_;
  std::unique_ptr<output::ReplayPlot> way_to_plot_;
  std::vector<std::string> written_;
};

Outcome<OutputFile*> Replay::open_file(const std::string& path, Kind kind) {
  if (path.empty()) return nullptr;
  auto created = OutputFile::create(path);
  if (!created) return tl::unexpected(created.error());
  outputs_.push_back({kind, std::move(*created), {}});
  return outputs_.back().file.get();
}

Outcome<void> Replay::open_output() {
  const auto file = open_file(options_.output, Kind::drives_a_machine);
  if (!file) return tl::unexpected(file.error());
  if (*file != nullptr) writer_ = std::make_unique<drive::PatternWriter>(format_.order, **file);
  return {};
}

Outcome<void> Replay::open_motion() {
  const auto file = open_file(options_.motion);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  motion_ = std::make_unique<output::MotionJson>(definition_.axes, **file);
  replay_.add_sink(static_cast<control::MotionSink&>(*motion_));
  return {};
}

Outcome<void> Replay::open_points() {
  const auto file = open_file(options_.points);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  points_ = std::make_unique<output::SetPointCsv>(definition_, **file);
  replay_.add_sink(static_cast<machine::AxisPointSink&>(*points_));
  return {};
}

Outcome<void> Replay::open_pulses() {
  const std::string& path = options_.pulses;
  const bool vcd = path.ends_with(".vcd");
  if (!path.empty() && path != "-" && !vcd && !path.ends_with(".csv"))
    return usage("--pulses " + path + ": step pulses end in .csv or .vcd");
  const auto file = open_file(path, Kind::drives_a_machine);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  std::vector<std::string> names;
  for (const machine::DrivenAxis& axis : definition_.driven) names.push_back(axis.name);
  if (vcd) {
    auto writer = std::make_unique<drive::PulseVcd>(
        names, definition_.drive.timing.direction_setup_ns, **file);
    outputs_.back().finish = [vcd_writer = writer.get()](OutputFile&) { vcd_writer->finish(); };
    pulses_ = std::move(writer);
  } else {
    pulses_ = std::make_unique<drive::PulseCsv>(names, **file);
  }
  replay_.add_sink(*pulses_);
  return {};
}

Outcome<void> Replay::open_plot() {
  const std::string& path = options_.plot;
  if (!path.empty() && !is_png(path) && !path.ends_with(".svg"))
    return usage("--plot " + path + ": a picture ends in .svg or .png");
  const auto file = open_file(path);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  plot_ = std::make_unique<output::PathPlot>(definition_.axes,
                                             options_.file + " on " + definition_.name);
  way_to_plot_ = std::make_unique<output::ReplayPlot>(replay_, *plot_);
  outputs_.back().finish = [this, png = is_png(path)](OutputFile& into) {
    into.write(png ? plot_->png() : plot_->svg());
  };
  return {};
}

Outcome<void> Replay::open_summary() {
  const auto file = open_file(options_.summary);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  outputs_.back().finish = [this](OutputFile& into) {
    into.write(output::replay_json(replay_, summary_));
  };
  return {};
}

Outcome<void> Replay::open() {
  constexpr std::array kSteps = {&Replay::open_output, &Replay::open_motion, &Replay::open_points,
                                 &Replay::open_pulses, &Replay::open_plot,   &Replay::open_summary};
  for (const auto step : kSteps) {
    if (auto opened = (this->*step)(); !opened) return opened;
  }
  return {};
}

base::Result<void> Replay::take(const drive::PatternRecord& record, std::uint64_t offset) {
  auto made = replay_.take(record);
  if (!made) {
    made.error().place.file = kPatternFile;
    made.error().offset = offset;
    return made;
  }
  if (writer_) writer_->write(record);
  return {};
}

base::Result<void> Replay::return_to_start(std::uint64_t offset) {
  const double per_mm = definition_.driven[index(drive::axis_of(drive::ArmAxis::z))].steps_per_unit;
  const std::int64_t up = per_mm > 0 ? 1 : -1;  // of a motor that turns the other way, up is less
  drive::ArmCounts counters = replay_.counters();
  counters[drive::ArmAxis::z] *= up;
  const auto safe_z = up * base::round_away(definition_.pattern.travel_z_mm * per_mm);
  base::Result<void> made;
  for (drive::FastMove move : drive::return_to_start(counters, safe_z)) {
    if (move.axis == drive::ArmAxis::z) move.count *= up;
    drive::each_record(move, [&](const drive::FastRecord& record) {
      if (made) made = take(record, offset);
    });
  }
  return made;
}

base::Result<void> Replay::play() {
  drive::PatternReader reader(sources_[kPatternFile], kPatternFile, format_);
  for (;;) {
    auto record = reader.next();
    if (!record) return base::unexpected(std::move(record.error()));
    if (!*record) break;
    if (auto made = take(**record, reader.offset()); !made) return made;
  }
  return options_.return_to_start ? return_to_start(sources_[kPatternFile].size())
                                  : base::Result<void>{};
}

Outcome<void> Replay::commit() {
  Outcome<void> result;
  for (Output& output : outputs_) {
    if (output.kind == Kind::drives_a_machine && summary_.alarm && !options_.keep_partial) continue;
    if (output.finish) output.finish(*output.file);
    auto committed = output.file->commit();
    if (committed && output.file->path() != "-") written_.push_back(output.file->path());
    if (!committed && result) result = committed;
  }
  outputs_.clear();
  return result;
}

void Replay::warn() const {
  if (replay_.beyond_travel().empty()) return;
  base::Diagnostic warning = base::make_error(
      base::Code::joint_limit, {.file = kPatternFile},
      "record " + std::to_string(replay_.beyond_travel_record()) + ": " + replay_.beyond_travel());
  warning.severity = base::Severity::warning;
  warning.offset = (replay_.beyond_travel_record() - 1) * drive::kRecordBytes;
  report(warning, sources_, options_.diagnostics);
}

ExitStatus Replay::run() {
  auto played = play();
  replay_.finish();
  summary_.file = options_.file;
  if (!played) summary_.alarm = std::move(played.error());
  if (auto committed = commit(); !committed) return fail(committed.error());
  if (summary_.alarm) report(*summary_.alarm, sources_, options_.diagnostics);
  warn();
  if (options_.diagnostics == DiagnosticFormat::text) {
    std::string text = output::replay_text(replay_, summary_);
    for (const std::string& path : written_) text += "  wrote " + output::printable(path) + "\n";
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
  return summary_.alarm ? ExitStatus::findings : ExitStatus::well;
}

}  // namespace

ExitStatus replay(const PatternOptions& options, const base::SourceSet& sources) {
  const auto definition = machine_of(options);
  if (!definition) return fail(definition.error());
  const auto machine = output::PatternMachine::of(*definition);
  if (!machine) return fail(machine.error());
  Replay replay(options, sources, *machine);
  if (auto opened = replay.open(); !opened) return fail(opened.error());
  return replay.run();
}

}  // namespace kerf::cli
