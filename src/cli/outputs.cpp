#include "cli/outputs.hpp"

#include <array>
#include <utility>

#include "drive/pulse_csv.hpp"
#include "drive/pulse_vcd.hpp"
#include "output/laser_pulses.hpp"
#include "output/motion_json.hpp"
#include "output/post.hpp"
#include "output/row_csv.hpp"
#include "output/set_point_csv.hpp"
#include "output/step_pulses.hpp"
#include "output/summary.hpp"
#include "output/taught_program.hpp"

namespace kerf::cli {
namespace {

using base::Failure;
using base::Outcome;
using base::OutputFile;

tl::unexpected<Failure> usage(const std::string& message) {
  return tl::unexpected(Failure{Failure::Kind::usage, message});
}

bool ends_as_picture(const std::string& path) {
  return path.ends_with(".svg") || path.ends_with(".png");
}

std::vector<std::string> axis_names(const machine::MachineDefinition& machine) {
  std::vector<std::string> names;
  for (const machine::DrivenAxis& axis : machine.driven) names.push_back(axis.name);
  return names;
}

}  // namespace

Outputs::Opened Outputs::open_file(const std::string& path, Kind kind) {
  if (path.empty()) return nullptr;
  auto created = OutputFile::create(path);
  if (!created) return tl::unexpected(created.error());
  outputs_.push_back({kind, std::move(*created), {}});
  return outputs_.back().file.get();
}

// Of the output that was opened last.
void Outputs::when_over(std::function<void(OutputFile&)> finish) {
  outputs_.back().finish = std::move(finish);
}

void Outputs::add(std::unique_ptr<control::MotionSink> sink) {
  machine_.add_sink(*sink);
  motion_sinks_.push_back(std::move(sink));
}

void Outputs::add(std::unique_ptr<machine::AxisPointSink> sink) {
  machine_.add_point_sink(*sink);
  point_sinks_.push_back(std::move(sink));
}

Outcome<void> Outputs::open_prints() {
  const Opened file = open_file(options_.dprnt.empty() ? "-" : options_.dprnt);
  if (!file) return tl::unexpected(file.error());
  machine_.set_print_output([into = *file](std::string_view text) { into->write(text); });
  return {};
}

Outcome<void> Outputs::open_motion() {
  const Opened file = open_file(options_.motion);
  if (!file) return tl::unexpected(file.error());
  if (*file != nullptr)
    add(std::make_unique<output::MotionJson>(machine_.definition().axes, **file));
  return {};
}

Outcome<void> Outputs::open_points() {
  const Opened file = open_file(options_.points);
  if (!file) return tl::unexpected(file.error());
  if (*file != nullptr) add(std::make_unique<output::SetPointCsv>(machine_.definition(), **file));
  return {};
}

Outcome<void> Outputs::open_pulses() {
  const std::string& path = options_.pulses;
  const bool vcd = path.ends_with(".vcd");
  if (!path.empty() && path != "-" && !vcd && !path.ends_with(".csv"))
    return usage("--pulses " + path + ": step pulses end in .csv or .vcd");
  const Opened file = open_file(path, Kind::drives_a_machine);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  if (vcd) {
    write_vcd(**file);
  } else {
    pulses_ = std::make_unique<drive::PulseCsv>(axis_names(machine_.definition()), **file);
  }
  add(std::make_unique<output::StepPulses>(machine_, *pulses_));
  return {};
}

void Outputs::write_vcd(OutputFile& file) {
  const machine::MachineDefinition& definition = machine_.definition();
  auto vcd = std::make_unique<drive::PulseVcd>(axis_names(definition),
                                               definition.drive.timing.direction_setup_ns, file);
  when_over([writer = vcd.get()](OutputFile&) { writer->finish(); });
  pulses_ = std::move(vcd);
}

Outcome<void> Outputs::open_pwm() {
  const machine::MachineDefinition& definition = machine_.definition();
  if (!options_.pwm.empty() && !definition.drive.laser.fitted())
    return usage("--pwm " + options_.pwm + ": " + definition.name + " has no laser");
  const Opened file = open_file(options_.pwm);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  auto pulses = std::make_unique<output::LaserPulses>(machine_, **file);
  when_over([laser = pulses.get()](OutputFile&) { laser->finish(); });
  add(std::move(pulses));
  return {};
}

Outcome<void> Outputs::open_rows() {
  const Opened file = open_file(options_.rows);
  if (!file) return tl::unexpected(file.error());
  if (*file != nullptr)
    add(std::make_unique<output::RowCsv>(machine_.definition().axes, machine_.memory(), **file));
  return {};
}

Outcome<void> Outputs::open_post() {
  const Opened file = open_file(options_.post, Kind::drives_a_machine);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  const machine::MachineDefinition& definition = machine_.definition();
  auto post = std::make_unique<output::Post>(definition.axes, **file, definition.drive.laser);
  when_over([this, writer = post.get()](OutputFile&) {
    writer->finish();
    remarks_ += writer->remark();
  });
  add(std::move(post));
  return {};
}

Outcome<void> Outputs::open_pattern() {
  if (options_.pattern.empty()) return {};
  auto motors = output::PatternMachine::of(machine_.definition());
  if (!motors) return usage("--pattern " + options_.pattern + ": " + motors.error().message);
  motors_ = std::move(*motors);
  const Opened file = open_file(options_.pattern, Kind::drives_a_machine);
  if (!file) return tl::unexpected(file.error());
  pattern_ =
      std::make_unique<drive::PatternWriter>(machine_.definition().pattern.byte_order, **file);
  auto maker = std::make_unique<output::PatternMaker>(machine_, *motors_, *pattern_);
  pattern_maker_ = maker.get();
  when_over([this](OutputFile&) {
    pattern_maker_->finish();
    remarks_ += output::pattern_text(pattern_maker_->report(), machine_.definition().pattern);
  });
  add(std::unique_ptr<control::MotionSink>(std::move(maker)));
  return {};
}

// Its steps come from the maker of the pattern, which is there before.
Outcome<void> Outputs::open_pattern_plot() {
  const std::string& path = options_.pattern_plot;
  const bool png = path.ends_with(".png");
  if (!path.empty() && !ends_as_picture(path))
    return usage("--pattern-plot " + path + ": a picture ends in .svg or .png");
  if (!path.empty() && pattern_maker_ == nullptr)
    return usage("--pattern-plot " + path + " shows what --pattern FILE makes: give that too");
  const Opened file = open_file(path);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  pattern_plot_ = std::make_unique<output::PatternPlot>(output::program_title(machine_) + " on " +
                                                        machine_.definition().name);
  pattern_maker_->watch(*pattern_plot_);
  when_over([this, png](OutputFile& into) {
    const output::PatternReport report = pattern_maker_->report();
    into.write(png ? pattern_plot_->png(report) : pattern_plot_->svg(report));
  });
  return {};
}

Outcome<void> Outputs::open_teach() {
  const machine::MachineDefinition& definition = machine_.definition();
  if (!options_.teach.empty() && !output::TaughtProgram::can_say(definition.axes))
    return usage("--teach " + options_.teach + ": taught points have the axes X Y Z A C, " +
                 definition.name + " has others");
  const Opened file = open_file(options_.teach, Kind::drives_a_machine);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  auto taught = std::make_unique<output::TaughtProgram>(machine_, **file);
  when_over([writer = taught.get()](OutputFile&) { writer->finish(); });
  add(std::move(taught));
  return {};
}

Outcome<void> Outputs::open_coverage() {
  const Opened file = open_file(options_.coverage);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  machine_.observe_blocks(
      [this](base::FileId source, std::uint32_t line) { coverage_.count(source, line); });
  when_over([this](OutputFile& into) {
    coverage_.write_csv(machine_.sources(), machine_.control().assumptions().list(), into);
  });
  return {};
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
  if (!options_.plot.empty() && !ends_as_picture(options_.plot))
    return usage("--plot " + options_.plot + ": a picture ends in .svg or .png");
  return {};
}

std::unique_ptr<output::PathPlot> Outputs::make_plot() const {
  const machine::MachineDefinition& definition = machine_.definition();
  const std::string title = output::program_title(machine_) + " on " + definition.name;
  if (options_.plot_energy)
    return std::make_unique<output::PathPlot>(definition.axes, title, definition.drive.laser);
  const auto colors = options_.plot_speed ? output::PlotColors::speeds : output::PlotColors::tools;
  return std::make_unique<output::PathPlot>(definition.axes, title, colors);
}

Outcome<void> Outputs::open_plot() {
  if (auto fits = check_plot(); !fits) return fits;
  const Opened file = open_file(options_.plot);
  if (!file) return tl::unexpected(file.error());
  if (*file == nullptr) return {};
  auto plot = make_plot();
  if (options_.plot_speed || options_.plot_energy) machine_.add_point_sink(*plot);
  when_over([this, picture = plot.get()](OutputFile& into) {
    into.write(options_.plot.ends_with(".png") ? picture->png() : picture->svg());
    remarks_ += picture->remark();
  });
  add(std::unique_ptr<control::MotionSink>(std::move(plot)));
  return {};
}

Outcome<void> Outputs::open_summary() {
  const Opened file = open_file(options_.summary);
  if (!file) return tl::unexpected(file.error());
  if (*file != nullptr)
    when_over([this](OutputFile& into) { into.write(output::summary_json(machine_)); });
  return {};
}

Outcome<void> Outputs::open() {
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

bool Outputs::is_written(const Output& output) const {
  return output.kind == Kind::record || options_.keep_partial ||
         machine_.status() == machine::VirtualMachine::Status::end;
}

Outcome<void> Outputs::commit(Output& output) {
  if (output.finish) output.finish(*output.file);
  auto committed = output.file->commit();
  const std::string& path = output.file->path();
  if (committed && path != "-") written_.push_back(path);
  return committed;
}

Outcome<void> Outputs::commit() {
  Outcome<void> result;
  for (Output& output : outputs_) {
    if (!is_written(output)) continue;
    auto committed = commit(output);
    if (!committed && result) result = committed;
  }
  outputs_.clear();
  return result;
}

}  // namespace kerf::cli
