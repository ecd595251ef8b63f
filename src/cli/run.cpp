#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "base/output_file.hpp"
#include "cli/commands.hpp"
#include "cli/failure.hpp"
#include "cli/machine_setup.hpp"
#include "cli/progress.hpp"
#include "machine/state_file.hpp"
#include "output/coverage.hpp"
#include "output/diagnostic_text.hpp"
#include "output/motion_json.hpp"
#include "output/path_plot.hpp"
#include "output/post.hpp"
#include "output/summary.hpp"

namespace kerf::cli {
namespace {

using base::Failure;
using base::Outcome;
using base::OutputFile;
using machine::VirtualMachine;
using Status = VirtualMachine::Status;

tl::unexpected<Failure> usage(const std::string& message) {
  return tl::unexpected(Failure{Failure::Kind::usage, message});
}

// What could drive a machine is written only when the run reached its end.
bool writes_post(const RunOptions& options, const VirtualMachine& machine) {
  return !options.post.empty() && (machine.status() == Status::end || options.keep_partial);
}

/// The outputs of a run: opened before the run, so that an output that cannot be written is told at
/// once; committed behind it, so that none looks complete that is not.
class Outputs {
 public:
  Outputs(const RunOptions& options, VirtualMachine& machine)
      : options_(options), machine_(machine) {}

  Outcome<void> open();
  Outcome<void> commit(const std::string& dialect);

 private:
  Outcome<void> open_file(const std::string& path, std::unique_ptr<OutputFile>& file);
  Outcome<void> open_plot();
  Outcome<void> commit_file(std::unique_ptr<OutputFile>& file);

  const RunOptions& options_;
  VirtualMachine& machine_;
  std::unique_ptr<OutputFile> summary_, motion_, plot_file_, dprnt_, post_file_, coverage_file_;
  std::unique_ptr<output::MotionJson> motion_json_;
  std::unique_ptr<output::PathPlot> plot_;
  std::unique_ptr<output::Post> post_;
  output::Coverage coverage_;
};

Outcome<void> Outputs::open_file(const std::string& path, std::unique_ptr<OutputFile>& file) {
  if (path.empty()) return {};
  auto created = OutputFile::create(path);
  if (!created) return tl::unexpected(created.error());
  file = std::move(*created);
  return {};
}

Outcome<void> Outputs::open_plot() {
  if (options_.plot.empty()) return {};
  if (!options_.plot.ends_with(".svg") && !options_.plot.ends_with(".png")) {
    return usage("--plot " + options_.plot + ": a picture ends in .svg or .png");
  }
  if (auto opened = open_file(options_.plot, plot_file_); !opened) return opened;
  plot_ = std::make_unique<output::PathPlot>(
      machine_.definition().axes, machine_.program_name() + " on " + machine_.definition().name);
  machine_.add_sink(*plot_);
  return {};
}

Outcome<void> Outputs::open() {
  if (auto opened = open_file(options_.summary, summary_); !opened) return opened;
  if (auto opened = open_file(options_.motion, motion_); !opened) return opened;
  if (auto opened = open_file(options_.dprnt.empty() ? "-" : options_.dprnt, dprnt_); !opened)
    return opened;
  if (auto opened = open_file(options_.post, post_file_); !opened) return opened;
  if (auto opened = open_file(options_.coverage, coverage_file_); !opened) return opened;
  if (auto opened = open_plot(); !opened) return opened;
  if (motion_) {
    motion_json_ = std::make_unique<output::MotionJson>(machine_.definition().axes, *motion_);
    machine_.add_sink(*motion_json_);
  }
  if (post_file_) {
    post_ = std::make_unique<output::Post>(machine_.definition().axes, *post_file_);
    machine_.add_sink(*post_);
  }
  if (coverage_file_) {
    machine_.observe_blocks(
        [this](base::FileId file, std::uint32_t line) { coverage_.count(file, line); });
  }
  machine_.set_print_output([this](std::string_view text) { dprnt_->write(text); });
  return {};
}

Outcome<void> Outputs::commit_file(std::unique_ptr<OutputFile>& file) {
  if (!file) return {};
  auto committed = file->commit();
  file.reset();
  return committed;
}

Outcome<void> Outputs::commit(const std::string& dialect) {
  if (!writes_post(options_, machine_)) post_file_.reset();
  if (post_file_) post_->finish();
  if (coverage_file_)
    coverage_.write_csv(machine_.sources(), machine_.controller().assumptions().list(),
                        *coverage_file_);
  if (plot_file_) plot_file_->write(options_.plot.ends_with(".png") ? plot_->png() : plot_->svg());
  if (summary_) summary_->write(output::summary_json(machine_, dialect));
  Outcome<void> result;
  for (std::unique_ptr<OutputFile>* file :
       {&dprnt_, &motion_, &post_file_, &coverage_file_, &plot_file_, &summary_}) {
    auto committed = commit_file(*file);
    if (!committed && result) result = committed;
  }
  return result;
}

void tell(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

void report(const RunOptions& options, VirtualMachine& machine, const ReadyMachine& ready) {
  const bool json = options.diagnostics == DiagnosticFormat::json;
  if (machine.alarm()) {
    tell(json ? output::diagnostic_json(*machine.alarm(), machine.sources())
              : output::diagnostic_text(*machine.alarm(), machine.sources()));
  }
  if (machine.notice()) {
    tell(json ? output::diagnostic_json(*machine.notice(), machine.sources())
              : output::diagnostic_text(*machine.notice(), machine.sources()));
  }
  if (json) return;
  tell(output::summary_text(machine, ready.dialect));
  if (!ready.why.empty()) tell("  " + ready.why + "\n");
  for (const std::string& path :
       {options.plot, options.summary, options.motion,
        writes_post(options, machine) ? options.post : std::string(), options.coverage}) {
    if (!path.empty() && path != "-") tell("  wrote " + output::printable(path) + "\n");
  }
}

Status run_showing_progress(const RunOptions& options, VirtualMachine& machine) {
  Progress progress;
  if (progress.wanted()) {
    machine.observe_progress([&] {
      const base::Place place = machine.controller().standing_at();
      const bool in_main = place.file == base::FileId{0};
      if (!in_main) return;
      progress.show(place.line_start, machine.sources()[place.file].size(),
                    machine.statistics().motions());
    });
  }
  const Status status = machine.run_to_end({options.max_seconds, options.max_motions, 0});
  machine.observe_progress(nullptr);
  return status;
}

}  // namespace

ExitStatus run(const RunOptions& options) {
  auto ready = make_ready(options);
  if (!ready) return fail(ready.error());
  VirtualMachine& machine = *ready->machine;
  Outputs outputs(options, machine);
  if (auto opened = outputs.open(); !opened) return fail(opened.error());
  const Status status = run_showing_progress(options, machine);
  if (auto committed = outputs.commit(ready->dialect); !committed) return fail(committed.error());
  if (!options.state.empty()) {
    if (auto written = machine::write_state(options.state, machine.memory()); !written)
      return fail(written.error());
  }
  report(options, machine, *ready);
  return exit_status_of(status);
}

}  // namespace kerf::cli
