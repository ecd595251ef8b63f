#include "face/cli/internal/draw_outputs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "drawing/contours/contours_writer.hpp"
#include "face/cli/failure.hpp"
#include "machine/dialect/taught_for.hpp"
#include "output/drawings/draw_report.hpp"
#include "output/programs/basic_program.hpp"
#include "output/programs/post_writer.hpp"
#include "output/programs/taught_program.hpp"
#include "output/records/motion_json.hpp"
#include "process/plan_reader.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;
using Kind = OutputFiles::Kind;

/// Gives a writer the comments of a plan at their motions: it follows the plan beside the machine.
class PassComments final : public motion::MotionSink {
 public:
  using Say = std::function<void(const std::string&, std::uint32_t)>;

  PassComments(const job::DrawnPlan& plan, Say say)
      : plan_(plan), reader_(plan.plan(), plan.drawing()), say_(std::move(say)) {}

  void take(const motion::Motion& /*motion*/) override {
    while (true) {
      if (next_ >= steps_.size()) {
        steps_.clear();
        next_ = 0;
        if (!reader_.next(steps_)) return;
        continue;
      }
      const process::Step& step = steps_[next_++];
      if (std::holds_alternative<motion::Motion>(step)) return;
      tell(std::get<process::PassBegins>(step));
    }
  }

 private:
  void tell(const process::PassBegins& pass) {
    const drawing::Drawing& drawing = plan_.drawing();
    const drawing::Entity& entity = drawing.entities[pass.entity];
    std::string text =
        fmt::format("{}: {} on {}", plan_.plan().operations[pass.operation].operation.name,
                    drawing.names[entity.kind], drawing.names[entity.layer]);
    if (entity.line > 0) text += fmt::format(", line {}", entity.line);
    say_(text, entity.line);
  }

  const job::DrawnPlan& plan_;
  process::PlanReader reader_;
  Say say_;
  std::vector<process::Step> steps_;
  std::size_t next_ = 0;
};

struct Ending {
  std::string_view ending;
  std::string_view language;
};
constexpr Ending kEndings[] = {{".nc", "gcode"},    {".ngc", "gcode"},       {".gcode", "gcode"},
                               {".tap", "gcode"},   {".bas", "laser-basic"}, {".tch", "teach"},
                               {".pat", "pattern"}, {".jsonl", "motion"}};

std::string_view language_of(const std::string& path) {
  for (const Ending& each : kEndings)
    if (path.ends_with(each.ending)) return each.language;
  return {};
}

}  // namespace

DrawOutputs::DrawOutputs(const DrawOptions& options, const job::DrawOrder& order,
                         const std::shared_ptr<const job::DrawnPlan>& plan)
    : options_(options), order_(order), plan_(plan) {}

void DrawOutputs::add(std::unique_ptr<motion::MotionSink> sink) {
  watchers_.motions.push_back(sink.get());
  sinks_.push_back(std::move(sink));
}

void DrawOutputs::comment_by(std::function<void(const std::string&, std::uint32_t)> say) {
  add(std::make_unique<PassComments>(*plan_, std::move(say)));
}

Outcome<void> DrawOutputs::open() {
  for (const std::string& drawing : options_.drawings) files_.keep_from(drawing);
  files_.keep_from(options_.job);
  for (const std::string& path : options_.outputs)
    if (auto opened = open_target(path); !opened) return opened;
  if (auto opened = open_contours(); !opened) return opened;
  if (auto opened = open_picture(); !opened) return opened;
  return files_.open(options_.report, Kind::record, [&](base::OutputFile&) {
    files_.when_over([this](base::OutputFile& file) { file.write(report()); });
  });
}

Outcome<void> DrawOutputs::open_target(const std::string& path) {
  const std::string_view language =
      options_.language.empty() ? language_of(path) : std::string_view(options_.language);
  targets_.push_back({path, std::string(language), "", 0, 0, {}});
  targets_over_.push_back([](output::DrawTarget&) {});
  if (language == "gcode") return open_gcode(path);
  if (language == "laser-basic") return open_basic(path);
  if (language == "teach") return open_taught(path);
  if (language == "motion") return open_motions(path);
  if (language == "pattern") return open_pattern(path);
  return usage("--output " + path + ": its ending names no language; --language does");
}

Outcome<void> DrawOutputs::open_gcode(const std::string& path) {
  return files_.open(path, Kind::drives_a_machine, [&](base::OutputFile& file) {
    targets_.back().flavour = options_.flavour;
    const output::PostFlavour& flavour = *output::find_flavour(options_.flavour);
    auto post = output::make_post(order_.definition, plan_->name(), file, {flavour});
    output::PostWriter* const writer = post.get();
    comment_by(
        [writer](const std::string& text, std::uint32_t line) { writer->comment(text, line); });
    files_.when_over([writer](base::OutputFile&) { writer->finish(); });
    targets_over_.back() = [writer](output::DrawTarget& target) {
      if (writer->lost() > 0) target.lost.push_back(writer->remark());
    };
    add(std::move(post));
  });
}

Outcome<void> DrawOutputs::open_basic(const std::string& path) {
  return files_.open(path, Kind::drives_a_machine, [&](base::OutputFile& file) {
    auto basic =
        std::make_unique<output::BasicProgram>(order_.definition.axes, plan_->name(), file);
    output::BasicProgram* const writer = basic.get();
    comment_by([writer](const std::string& text, std::uint32_t) { writer->comment(text); });
    files_.when_over([writer](base::OutputFile&) { writer->finish(); });
    targets_over_.back() = [writer](output::DrawTarget& target) { target.lost = writer->lost(); };
    add(std::move(basic));
  });
}

Outcome<void> DrawOutputs::open_taught(const std::string& path) {
  const machine::MachineDefinition& definition = order_.definition;
  if (!output::TaughtProgram::can_say(definition.axes))
    return usage("--output " + path + ": taught points have the axes X Y Z A C, " +
                 definition.name + " has others");
  return files_.open(path, Kind::drives_a_machine, [&](base::OutputFile& file) {
    const control::TaughtFor self = machine::taught_for(definition);
    auto taught = std::make_unique<output::TaughtProgram>(
        definition.axes, output::TaughtProgram::Head{self.period_ms, self.radii},
        [](const auto&...) {}, file);
    files_.when_over([writer = taught.get()](base::OutputFile&) { writer->finish(); });
    add(std::move(taught));
  });
}

/// The maker is the machine's judge: it is made when there is a machine.
Outcome<void> DrawOutputs::open_pattern(const std::string& path) {
  auto motors = machine::PatternMachine::of(order_.definition);
  if (!motors) return usage("--output " + path + ": " + motors.error().message);
  motors_ = std::move(*motors);
  return files_.open(path, Kind::drives_a_machine, [&](base::OutputFile& file) {
    watchers_.prepare = [this, &file](machine::BatchRun& run) {
      pattern_ = std::make_unique<drive::PatternWriter>(order_.definition.pattern.byte_order, file);
      maker_ = std::make_unique<engraver::PatternMaker>(run, *motors_, *pattern_);
    };
    watchers_.finish = [this] {
      maker_->finish();
      report_of_pattern_ = maker_->report();
    };
    targets_over_.back() = [this](output::DrawTarget& target) {
      target.deviation_mm = report_of_pattern_.measured.mm;
    };
  });
}

Outcome<void> DrawOutputs::open_motions(const std::string& path) {
  return files_.open(path, Kind::record, [&](base::OutputFile& file) {
    add(std::make_unique<output::MotionJson>(order_.definition.axes, nullptr, file));
  });
}

Outcome<void> DrawOutputs::open_contours() {
  const std::string& path = options_.contours;
  using Write = void (*)(const std::vector<drawing::ContourLayer>&, const drawing::WritePiece&);
  const Write write = path.ends_with(".svg")   ? drawing::write_contours_svg
                      : path.ends_with(".dxf") ? drawing::write_contours_dxf
                                               : drawing::write_contours_json;
  const bool fits = path.empty() || path == "-" || path.ends_with(".svg") ||
                    path.ends_with(".dxf") || path.ends_with(".json");
  if (!fits) return usage("--contours " + path + ": its name has to end in .json, .svg or .dxf");
  return files_.open(path, Kind::record, [&](base::OutputFile& file) {
    write(job::layers_of(*plan_), [&](std::string_view piece) { file.write(piece); });
  });
}

Outcome<void> DrawOutputs::open_picture() {
  if (auto fits = check_picture("--picture", options_.picture); !fits) return fits;
  if (options_.run.plot_energy && options_.picture.empty())
    return usage("--plot-energy says how --picture FILE is coloured: give that too");
  if (options_.run.plot_energy && !order_.definition.drive.laser.fitted())
    return usage("--plot-energy: " + order_.definition.name + " has no laser");
  return files_.open(options_.picture, Kind::record, [&](base::OutputFile&) {
    const std::string title = plan_->name() + " on " + order_.definition.name;
    const motion::AxisSetup& axes = order_.definition.axes;
    plot_ = options_.run.plot_energy
                ? std::make_unique<output::PathPlot>(axes, title, order_.definition.drive.laser)
                : std::make_unique<output::PathPlot>(axes, title);
    if (options_.run.plot_energy) watchers_.points.push_back(plot_.get());
    watchers_.motions.push_back(plot_.get());
    files_.when_over([this](base::OutputFile& file) {
      file.write(is_png(options_.picture) ? plot_->png() : plot_->svg());
    });
  });
}

/// Behind the programs, whose sizes it tells.
std::string DrawOutputs::report() const {
  for (output::DrawTarget& target : facts_->targets) {
    std::error_code none;
    const auto bytes = std::filesystem::file_size(target.file, none);
    if (!none) target.bytes = bytes;
  }
  return output::draw_report(*facts_);
}

Outcome<void> DrawOutputs::commit(output::DrawFacts& facts, bool programs) {
  for (std::size_t i = 0; programs && i < targets_.size(); ++i) {
    targets_over_[i](targets_[i]);
    facts.targets.push_back(targets_[i]);
  }
  facts_ = &facts;
  return files_.commit(programs ? OutputFiles::Which::all : OutputFiles::Which::records_only);
}

}  // namespace kerf::cli
