#include "face/server/hub/preview.hpp"

#include <chrono>

#include "face/server/protocol/diagnostic_json.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/language.hpp"
#include "machine/run/virtual_machine.hpp"

namespace kerf::server {
namespace {

using Clock = std::chrono::steady_clock;
using machine::VirtualMachine;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

Json failure_json(const std::string& code, const std::string& message) {
  return {{"severity", "error"}, {"code", code}, {"message", message}, {"file", ""},
          {"line", 0},           {"column", 0},  {"length", 0},        {"program", ""},
          {"cause", ""},         {"remedy", ""}};
}

// A pattern begins at the zero of its motors, wherever they stand now.
machine::MachineDefinition definition_of(const PreviewOrder& order) {
  if (order.dialect != machine::kPatternDialect) return order.definition;
  return machine::PatternMachine::at_zero(order.definition);
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
  Run(Preview& preview, const Observer& observer)
      : preview_(preview),
        observer_(observer),
        machine_(definition_of(preview.order_), preview.order_.memory,
                 {.pages = {}, .dialect = preview.order_.dialect}),
        chunks_(machine_.definition(), output::PathChunks::Source::preview, preview.order_.run,
                [this](const std::string& chunk) { keep(chunk); }) {}

  void go() {
    auto file = open();
    if (!file) return finish(failure_json("FILE", file.error().message));
    machine_.add_library_folder(preview_.order_.library_folder);
    machine_.load(std::move(*file));
    give_inputs();
    machine_.set_block_skip(preview_.order_.skip_levels);
    machine_.set_optional_stop(preview_.order_.optional_stop);
    machine_.search_alarms();
    machine_.add_sink(chunks_);
    machine_.add_point_sink(chunks_);
    machine_.observe_progress([this] { look_at_clock(); });
    const auto status = machine_.run_to_end({.seconds = kMostSeconds,
                                             .input_waits = false,
                                             .unwanted = preview_.unwanted_.get_token()});
    if (preview_.cancelled() && disk_error_.empty()) return;
    chunks_.finish();
    finish(error_of(status));
  }

 private:
  // Only G-code reads any.
  void give_inputs() {
    constexpr std::size_t kFirstWord = 1032;
    const auto& words = preview_.order_.inputs;
    for (std::size_t i = 0; i < words.size(); ++i)
      static_cast<void>(machine_.set_variable("#" + std::to_string(kFirstWord + i),
                                              static_cast<double>(words[i])));
  }

  [[nodiscard]] base::Outcome<std::unique_ptr<base::SourceFile>> open() const {
    const auto program = preview_.order_.program();
    if (!program) return tl::unexpected(program.error());
    return program->open();
  }

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

  [[nodiscard]] Json error_of(VirtualMachine::Status status) {
    if (!disk_error_.empty()) return failure_json("DISK", disk_error_);
    if (status == VirtualMachine::Status::alarm && machine_.alarm())
      return diagnostic_json(*machine_.alarm(), machine_.sources());
    if (status == VirtualMachine::Status::budget && machine_.notice())
      return diagnostic_json(*machine_.notice(), machine_.sources());
    return nullptr;
  }

  [[nodiscard]] PreviewState state(bool done, Json error) const {
    PreviewState state;
    state.run = preview_.order_.run;
    state.done = done;
    state.totals = chunks_.totals();
    state.files = files_of(machine_.sources());
    state.error = std::move(error);
    state.has_read_inputs = machine_.has_read_inputs();
    return state;
  }

  void finish(Json error) {
    PreviewState last = state(true, std::move(error));
    const machine::AlarmSearch* const search = machine_.alarm_search();
    if (disk_error_.empty() && search != nullptr) add_findings(*search, last);
    observer_(last);
  }

  void add_findings(const machine::AlarmSearch& search, PreviewState& state) const {
    for (const base::Diagnostic& each : search.findings())
      state.findings.push_back(diagnostic_json(each, machine_.sources()));
    if (const auto& stop = search.stop())
      state.stop = {{"motion", stop->motion}, {"time_s", stop->time_s}};
    state.is_cut_short = search.is_cut_short();
  }

  Preview& preview_;
  const Observer& observer_;
  VirtualMachine machine_;
  output::PathChunks chunks_;
  Clock::time_point told_chunks_ = Clock::now();
  std::string disk_error_;
};

void Preview::run(const Observer& observer) {
  if (cancelled()) return;
  const machine::MachineDefinition& machine = order_.definition;
  const std::string& dialect = order_.dialect.empty() ? machine.dialect : order_.dialect;
  const auto known = machine::check_dialect(machine, dialect);
  if (known) return Run(*this, observer).go();
  PreviewState state;
  state.run = order_.run;
  state.done = true;
  state.error = failure_json("DIALECT", known.error().message);
  observer(state);
}

}  // namespace kerf::server
