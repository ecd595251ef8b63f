#include "face/cli/outputs.hpp"

#include <array>
#include <utility>

#include "face/cli/failure.hpp"
#include "job/facts_of_run.hpp"
#include "machine/dialect/taught_for.hpp"
#include "output/programs/taught_program.hpp"
#include "output/records/laser_pulses.hpp"
#include "output/records/lathe_row_csv.hpp"
#include "output/records/motion_json.hpp"
#include "output/records/row_csv.hpp"
#include "output/records/set_point_csv.hpp"
#include "output/records/step_pulses.hpp"
#include "output/reports/summary.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;
using base::OutputFile;

constexpr auto kRecord = OutputFiles::Kind::record;
constexpr auto kDrives = OutputFiles::Kind::drives_a_machine;

}  // namespace

void Outputs::add(std::unique_ptr<motion::MotionSink> sink) {
  machine_.add_sink(*sink);
  motion_sinks_.push_back(std::move(sink));
}

void Outputs::add(std::unique_ptr<motion::AxisPointSink> sink) {
  machine_.add_point_sink(*sink);
  point_sinks_.push_back(std::move(sink));
}

Outcome<void> Outputs::open_prints() {
  return files_.open(options_.dprnt.empty() ? "-" : options_.dprnt, kRecord, [&](OutputFile& file) {
    machine_.set_print_output([&file](std::string_view text) { file.write(text); });
  });
}

Outcome<void> Outputs::open_motion() {
  return files_.open(options_.motion, kRecord, [&](OutputFile& file) {
    add(std::make_unique<output::MotionJson>(
        machine_.definition().axes, &machine_.sources(), file,
        output::MotionJson::Origin{job::source_of(machine_), &machine_.memory()}));
  });
}

Outcome<void> Outputs::open_points() {
  return files_.open(options_.points, kRecord, [&](OutputFile& file) {
    add(std::make_unique<output::SetPointCsv>(machine_.definition(), file));
  });
}

Outcome<void> Outputs::open_pulses() {
  auto sink = open_pulse_file(files_, options_.pulses, machine_.definition());
  if (!sink) return tl::unexpected(sink.error());
  if (!*sink) return {};
  pulses_ = std::move(*sink);
  add(std::make_unique<output::StepPulses>(machine_.definition(), job::alarm_of(machine_),
                                           *pulses_));
  return {};
}

Outcome<void> Outputs::open_pwm() {
  const machine::MachineDefinition& definition = machine_.definition();
  if (!options_.pwm.empty() && !definition.drive.laser.fitted())
    return usage("--pwm " + options_.pwm + ": " + definition.name + " has no laser");
  return files_.open(options_.pwm, kRecord, [&](OutputFile& file) {
    auto pulses = std::make_unique<output::LaserPulses>(machine_.definition().drive.laser,
                                                        job::alarm_of(machine_), file);
    files_.when_over([laser = pulses.get()](OutputFile&) { laser->finish(); });
    add(std::move(pulses));
  });
}

Outcome<void> Outputs::open_rows() {
  return files_.open(options_.rows, kRecord, [&](OutputFile& file) {
    const machine::MachineDefinition& definition = machine_.definition();
    if (definition.axes.turns() && definition.axes.find('Z')) {
      add(std::make_unique<output::LatheRowCsv>(definition, machine_.memory(), file));
    } else {
      add(std::make_unique<output::RowCsv>(definition.axes, machine_.memory(), file));
    }
  });
}

Outcome<void> Outputs::open_post() {
  auto opened = post_.open(machine_.definition(), job::title_of(machine_));
  if (opened && post_.writer() != nullptr) machine_.add_sink(*post_.writer());
  return opened;
}

Outcome<void> Outputs::open_pattern() {
  if (options_.pattern.empty()) return {};
  auto motors = machine::PatternMachine::of(machine_.definition());
  if (!motors) return usage("--pattern " + options_.pattern + ": " + motors.error().message);
  motors_ = std::move(*motors);
  return files_.open(options_.pattern, kDrives, [&](OutputFile& file) {
    const machine::PatternSettings& settings = machine_.definition().pattern;
    pattern_ = std::make_unique<drive::PatternWriter>(settings.byte_order, file);
    auto maker = std::make_unique<engraver::PatternMaker>(machine_, *motors_, *pattern_);
    pattern_maker_ = maker.get();
    files_.when_over([this](OutputFile&) {
      pattern_maker_->finish();
      pattern_report_ = pattern_maker_->report();
      remarks_ += engraver::pattern_text(*pattern_report_, machine_.definition());
    });
    motion_sinks_.push_back(std::move(maker));  // the machine's judge, no sink of it
  });
}

// Its steps come from the maker of the pattern, which is there before.
Outcome<void> Outputs::open_pattern_plot() {
  const std::string& path = options_.pattern_plot;
  if (auto fits = check_picture("--pattern-plot", path); !fits) return fits;
  if (!path.empty() && pattern_maker_ == nullptr)
    return usage("--pattern-plot " + path + " shows what --pattern FILE makes: give that too");
  return files_.open(path, kRecord, [&](OutputFile&) {
    pattern_plot_ = std::make_unique<engraver::PatternPlot>(title());
    pattern_maker_->watch(*pattern_plot_);
    files_.when_over([this, png = is_png(path)](OutputFile& into) {
      const engraver::PatternReport report = pattern_maker_->report();
      into.write(png ? pattern_plot_->png(report) : pattern_plot_->svg(report));
    });
  });
}

Outcome<void> Outputs::open_teach() {
  const machine::MachineDefinition& definition = machine_.definition();
  if (!options_.teach.empty() && !output::TaughtProgram::can_say(definition.axes))
    return usage("--teach " + options_.teach + ": taught points have the axes X Y Z A C, " +
                 definition.name + " has others");
  return files_.open(options_.teach, kDrives, [&](OutputFile& file) {
    const control::TaughtFor self = machine::taught_for(machine_.definition());
    auto taught = std::make_unique<output::TaughtProgram>(
        machine_.definition().axes, output::TaughtProgram::Head{self.period_ms, self.radii},
        job::alarm_of(machine_), file);
    files_.when_over([writer = taught.get()](OutputFile&) { writer->finish(); });
    add(std::move(taught));
  });
}

Outcome<void> Outputs::open_coverage() {
  return files_.open(options_.coverage, kRecord, [&](OutputFile&) {
    machine_.observe_blocks(
        [this](base::FileId source, std::uint32_t line) { coverage_.count(source, line); });
    files_.when_over([this](OutputFile& into) {
      coverage_.write_csv(machine_.sources(), machine_.control().assumptions().list(), into);
    });
  });
}

Outcome<void> Outputs::check_plot() const {
  const machine::MachineDefinition& definition = machine_.definition();
  const std::string colours = options_.plot_speed ? "--plot-speed" : "--plot-energy";
  const bool coloured = options_.plot_speed || options_.plot_energy;
  if (coloured && options_.plot.empty())
    return usage(colours + " says how --plot FILE is coloured: give that too");
  if (options_.plot_speed && options_.plot_energy)
    return usage("--plot-speed and --plot-energy: a cut has one colour");
  if (options_.plot_energy && !definition.drive.laser.fitted())
    return usage("--plot-energy: " + definition.name + " has no laser");
  return check_picture("--plot", options_.plot);
}

std::string Outputs::title() const {
  return job::title_of(machine_) + " on " + machine_.definition().name;
}

std::unique_ptr<output::PathPlot> Outputs::make_plot() const {
  const machine::MachineDefinition& definition = machine_.definition();
  if (options_.plot_energy)
    return std::make_unique<output::PathPlot>(definition.axes, title(), definition.drive.laser);
  const auto colors = options_.plot_speed ? output::PlotColors::speeds : output::PlotColors::tools;
  return std::make_unique<output::PathPlot>(
      definition.axes, title(), colors,
      output::ToolTable{&machine_.memory(), definition.parameters.geometry_by_tool});
}

Outcome<void> Outputs::open_plot() {
  if (auto fits = check_plot(); !fits) return fits;
  return files_.open(options_.plot, kRecord, [&](OutputFile&) {
    auto plot = make_plot();
    if (options_.plot_speed || options_.plot_energy) machine_.add_point_sink(*plot);
    files_.when_over([this, picture = plot.get()](OutputFile& into) {
      into.write(is_png(options_.plot) ? picture->png() : picture->svg());
      remarks_ += picture->remark();
      energy_ = picture->energy_json();
    });
    add(std::unique_ptr<motion::MotionSink>(std::move(plot)));
  });
}

// Null: it was asked for and not written.
output::SummaryOfOutputs Outputs::in_summary() const {
  output::SummaryOfOutputs members;
  if (!options_.pattern.empty())
    members.pattern = pattern_report_
                          ? engraver::pattern_json(*pattern_report_, machine_.definition().pattern)
                          : "null";
  if (!options_.post.empty()) members.post = post_.report().empty() ? "null" : post_.report();
  members.energy = energy_;
  members.stock = stock_;
  return members;
}

// Behind all others: it tells what they have become.
Outcome<void> Outputs::open_summary() {
  return files_.open(options_.summary, kRecord, [&](OutputFile&) {
    files_.when_over([this](OutputFile& into) {
      into.write(output::summary_json(facts_of(ready_), in_summary()));
    });
  });
}

Outcome<void> Outputs::open() {
  for (const std::string* const input : {&options_.program, &options_.tools, &options_.offsets,
                                         &options_.state, &options_.table.set_up})
    files_.keep_from(*input);
  if (options_.machine.ends_with(".toml")) files_.keep_from(options_.machine);
  constexpr std::array kSteps = {
      &Outputs::open_prints, &Outputs::open_motion,   &Outputs::open_points,
      &Outputs::open_pulses, &Outputs::open_pwm,      &Outputs::open_rows,
      &Outputs::open_post,   &Outputs::open_pattern,  &Outputs::open_pattern_plot,
      &Outputs::open_teach,  &Outputs::open_coverage, &Outputs::open_plot,
      &Outputs::open_summary};
  for (const auto step : kSteps) {
    if (auto opened = (this->*step)(); !opened) return opened;
  }
  return {};
}

Outcome<void> Outputs::commit() {
  const bool at_end = machine_.status() == machine::RunStatus::end;
  if (at_end) post_.judge();
  auto committed = files_.commit(
      at_end || options_.keep_partial ? OutputFiles::Which::all : OutputFiles::Which::records_only);
  remarks_ += post_.remark();
  return committed;
}

}  // namespace kerf::cli
