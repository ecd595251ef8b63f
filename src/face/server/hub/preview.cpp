#include "face/server/hub/preview.hpp"

#include <chrono>

#include "face/server/protocol/diagnostic_json.hpp"

namespace kerf::server {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

Json failure_json(const std::string& code, const std::string& message) {
  return {{"severity", "error"}, {"code", code}, {"message", message}, {"file", ""},
          {"line", 0},           {"column", 0},  {"length", 0},        {"program", ""},
          {"cause", ""},         {"remedy", ""}};
}

std::vector<std::string> files_of(const base::SourceSet& sources) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; sources.contains(base::FileId{i}); ++i)
    names.push_back(file_label(sources[base::FileId{i}].name()));
  return names;
}

}  // namespace

// One run of the machine, with the clock that says when chunks go out.
class Preview::Run {
 public:
  Run(Preview& preview, const Observer& observer, job::Run& run)
      : preview_(preview),
        observer_(observer),
        run_(run),
        chunks_(machine().definition(), output::PathChunks::Source::preview, preview.order_.run,
                [this](const std::string& chunk) { keep(chunk); }) {}

  void go() {
    machine().add_sink(chunks_);
    machine().add_point_sink(chunks_);
    machine().observe_progress([this] { look_at_clock(); });
    const machine::RunStatus status = run_.go();
    if (preview_.cancelled() && disk_error_.empty()) return;
    chunks_.finish();
    finish(error_of(status));
  }

 private:
  [[nodiscard]] machine::BatchRun& machine() const { return run_.machine(); }

  void keep(const std::string& chunk) {
    if (auto kept = preview_.chunks_->add(chunk); !kept && disk_error_.empty()) {
      disk_error_ = kept.error().message;
      preview_.cancel();
    }
    told_chunks_ = Clock::now();
  }

  void look_at_clock() {
    if (preview_.cancelled()) return;
    const auto now = Clock::now();
    const bool none_yet = preview_.chunks_->count() == 0;
    if (seconds_between(told_chunks_, now) < (none_yet ? kFirst_s : kNext_s)) return;
    chunks_.flush();
    told_chunks_ = now;
    observer_(state(false, nullptr));
  }

  [[nodiscard]] Json error_of(machine::RunStatus status) {
    if (!disk_error_.empty()) return failure_json("DISK", disk_error_);
    if (status == machine::RunStatus::alarm && machine().alarm())
      return diagnostic_json(*machine().alarm(), machine().sources());
    if (status == machine::RunStatus::budget && machine().notice())
      return diagnostic_json(*machine().notice(), machine().sources());
    return nullptr;
  }

  [[nodiscard]] PreviewState state(bool done, Json error) const {
    PreviewState state;
    state.run = preview_.order_.run;
    state.done = done;
    state.totals = chunks_.totals();
    state.files = files_of(machine().sources());
    state.error = std::move(error);
    state.has_read_inputs = machine().has_read_inputs();
    return state;
  }

  void finish(Json error) {
    PreviewState last = state(true, std::move(error));
    const machine::AlarmSearch* const search = machine().alarm_search();
    if (disk_error_.empty() && search != nullptr) add_findings(*search, last);
    observer_(last);
  }

  void add_findings(const machine::AlarmSearch& search, PreviewState& state) const {
    for (const base::Diagnostic& each : search.findings())
      state.findings.push_back(diagnostic_json(each, machine().sources()));
    if (const auto& stop = search.stop())
      state.stop = {{"motion", stop->motion}, {"time_s", stop->time_s}};
    state.is_cut_short = search.is_cut_short();
  }

  Preview& preview_;
  const Observer& observer_;
  job::Run& run_;
  output::PathChunks chunks_;
  Clock::time_point told_chunks_ = Clock::now();
  std::string disk_error_;
};

base::Outcome<std::unique_ptr<job::Run>> Preview::make_run() {
  auto program = order_.program();
  if (!program) return tl::unexpected(program.error());
  order_.job.program = std::move(*program);
  order_.job.behind_alarms = true;
  order_.job.budget = {
      .seconds = kMostSeconds, .input_waits = false, .unwanted = unwanted_.get_token()};
  return job::Run::of(order_.job);
}

void Preview::run(const Observer& observer) {
  if (cancelled()) return;
  const auto run = make_run();
  if (run) return Run(*this, observer, **run).go();
  PreviewState state;
  state.run = order_.run;
  state.done = true;
  const bool readable = run.error().kind == base::Failure::Kind::usage;
  state.error = failure_json(readable ? "DIALECT" : "FILE", run.error().message);
  observer(state);
}

}  // namespace kerf::server
