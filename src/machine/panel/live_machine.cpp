#include "machine/panel/live_machine.hpp"

#include <cmath>
#include <limits>

#include "lang/teach/record_parser.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/panel/internal/forecast.hpp"
#include "machine/panel/internal/journal.hpp"
#include "machine/panel/internal/journal_text.hpp"
#include "machine/panel/internal/key_rules.hpp"
#include "machine/panel/internal/live_core.hpp"
#include "machine/panel/internal/read_again.hpp"
#include "machine/panel/point_capture.hpp"

namespace kerf::machine {

using base::Refusal;

namespace {

RunStart at_power_on(const MachineDefinition& definition, control::Memory memory,
                     LiveMachine::Settings settings) {
  std::string dialect = settings.dialect.empty() ? definition.dialect : settings.dialect;
  return {definition, std::move(memory), std::move(settings), std::move(dialect)};
}

}  // namespace

/// The machine, what was done with it in this run, and the points that were taught.
class LiveMachine::Impl {
 public:
  Impl(const MachineDefinition& definition, control::Memory memory, Settings settings);
  /// A machine that has done what the journal says.
  Impl(Journal done, std::unique_ptr<LiveCore> made)
      : core(std::move(made)), journal(std::move(done)), capture(core->definition()) {}

  // Each does what the operator asks for, and remembers it.
  Outcome perform_now(const Operation& key);
  Outcome begin(const Operation& key);
  [[nodiscard]] bool perform_at_axes(const Operation& key);
  [[nodiscard]] Outcome step_back();
  [[nodiscard]] base::Outcome<LiveCore*> core_at(double time_s);
  [[nodiscard]] LiveCore* earlier(double time_s);
  [[nodiscard]] LiveCore* later(double time_s);

  std::unique_ptr<LiveCore> core;
  Journal journal;
  std::unique_ptr<Replay> replay;
  std::unique_ptr<Forecast> forecast;
  LiveCore* looked_at = nullptr;  // the core of the last instant that was asked for; null: none
  machine::Capture capture;
  std::vector<motion::MotionSink*> sinks;
  std::vector<motion::AxisPointSink*> point_sinks;
  std::shared_ptr<const Snapshot> shown;  // null: something may have changed since

 private:
  void put(std::unique_ptr<LiveCore> other);
  void touch() {
    shown.reset();
    looked_at = nullptr;
    replay.reset();
    forecast.reset();
  }
};

LiveMachine::Impl::Impl(const MachineDefinition& definition, control::Memory memory,
                        Settings settings)
    : core(std::make_unique<LiveCore>(
          at_power_on(definition, std::move(memory), std::move(settings)))),
      journal{core->run_start(), 0},
      capture(definition) {}

LiveMachine::Outcome LiveMachine::Impl::perform_now(const Operation& key) {
  const LiveCore::Moment now = core->moment();
  const Operation full = in_full(key, *core);
  Outcome done = core->perform(key);
  if (done) journal.entries.push_back({now, full});
  touch();
  return done;
}

// Where the program has been read farther than the axes are. False: it has no block to act on.
bool LiveMachine::Impl::perform_at_axes(const Operation& key) {
  auto again = read_again(journal, *core, key);
  if (!again) return false;
  again->core->replace(*core);
  put(std::move(again->core));
  journal = std::move(again->journal);
  touch();
  return true;
}

// The points that follow go on where the last ones ended.
void LiveMachine::Impl::put(std::unique_ptr<LiveCore> other) {
  for (motion::MotionSink* const sink : sinks) other->add_sink(*sink);
  for (motion::AxisPointSink* const sink : point_sinks) other->add_point_sink(*sink);
  other->set_limit(core->limit());
  core = std::move(other);
}

// A run begins with it.
LiveMachine::Outcome LiveMachine::Impl::begin(const Operation& key) {
  Journal from{core->run_start(), core->run().number()};
  const Operation full = in_full(key, *core);
  Outcome done = core->perform(key);
  if (done) {
    journal = std::move(from);
    journal.entries.push_back({{}, full});
  } else if (core->points() == 0) {
    journal = {core->run_start(), core->run().number()};  // what was tried has begun anew
  }
  touch();
  return done;
}

// The blocks that were begun are counted by making the run again; so it stops one of them earlier
// the next time.
LiveMachine::Outcome LiveMachine::Impl::step_back() {
  if (core->is_active()) return refused(Refusal::running_hold_or_stop);
  Replay all(journal);
  all.core().set_limit(core->limit());
  all.go_to(std::numeric_limits<double>::infinity());
  if (core->limit().reached()) return refused(Refusal::takes_too_long);
  const bool waits = all.core().machine().halt() == control::Halt::gate;
  const std::uint64_t begun = all.core().stepper().blocks();
  const std::uint64_t done = waits && begun > 0 ? begun - 1 : begun;
  if (done == 0) return refused(Refusal::at_beginning);
  Replay back(journal, done);
  back.core().set_limit(core->limit());
  back.go_to(std::numeric_limits<double>::infinity());
  if (core->limit().reached()) return refused(Refusal::takes_too_long);
  const std::size_t kept = back.done();
  std::unique_ptr<LiveCore> there = back.take();
  there->stepper().search_block(0);
  there->replace(*core);
  // What waited for a later block acts now; what has acted on an earlier one shows.
  for (std::size_t i = 0; i < journal.entries.size(); ++i) {
    const Journal::Entry& entry = journal.entries[i];
    if (!entry.before_block) continue;
    const bool acted = Journal::has_acted(entry, done);
    if (i < kept && !acted) static_cast<void>(there->take_effect(*entry.key));
    if (i >= kept && acted) there->show(*entry.key);
  }
  journal.go_back(done, kept, there->moment());
  put(std::move(there));
  core->tell_sinks();
  touch();
  return {};
}

base::Outcome<LiveCore*> LiveMachine::Impl::core_at(double time_s) {
  if (!(time_s >= 0)) return refused("times of a run begin with 0 s");
  looked_at = time_s > core->time_s() ? later(time_s) : earlier(time_s);
  if (core->limit().reached()) return refused(Refusal::takes_too_long);
  return looked_at;
}

LiveCore* LiveMachine::Impl::earlier(double time_s) {
  if (replay && replay->time_s() > time_s) replay.reset();
  if (!replay) replay = std::make_unique<Replay>(journal);
  replay->core().set_limit(core->limit());
  replay->go_to(time_s);
  return &replay->core();
}

// Of the run that is under way, or else of the next one.
LiveCore* LiveMachine::Impl::later(double time_s) {
  if (forecast && forecast->time_s() > time_s) forecast.reset();
  if (!forecast)
    forecast = std::make_unique<Forecast>(would_begin(core->standing()) ? core->run_start()
                                                                        : journal.start);
  forecast->core().set_limit(core->limit());
  forecast->go_to(time_s);
  return &forecast->core();
}

LiveMachine::LiveMachine(const MachineDefinition& definition, control::Memory memory,
                         Settings settings)
    : impl_(std::make_unique<Impl>(definition, std::move(memory), std::move(settings))) {}
LiveMachine::LiveMachine(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveMachine::~LiveMachine() = default;
LiveMachine::LiveMachine(LiveMachine&&) noexcept = default;
LiveMachine& LiveMachine::operator=(LiveMachine&&) noexcept = default;

void LiveMachine::add_sink(motion::MotionSink& sink) {
  impl_->sinks.push_back(&sink);
  impl_->core->add_sink(sink);
}

void LiveMachine::add_point_sink(motion::AxisPointSink& sink) {
  impl_->point_sinks.push_back(&sink);
  impl_->core->add_point_sink(sink);
}

LiveMachine::Outcome LiveMachine::perform(const Operation& key) {
  if (std::holds_alternative<StepBack>(key)) return impl_->step_back();
  if (begins_run(key, *impl_->core)) return impl_->begin(key);
  const auto later = acts_on_axes(key, *impl_->core);
  return later && impl_->perform_at_axes(*later) ? Outcome{} : impl_->perform_now(key);
}

void LiveMachine::advance(double seconds) {
  if (!impl_->core->is_active()) return;
  impl_->core->advance(seconds);
  impl_->shown.reset();
}

std::shared_ptr<const Snapshot> LiveMachine::snapshot() {
  if (!impl_->shown) impl_->shown = std::make_shared<const Snapshot>(impl_->core->snapshot());
  return impl_->shown;
}

// The program

LiveMachine::Outcome LiveMachine::can_load(const Load& key) const {
  return impl_->core->can_load(key);
}

const std::optional<base::ProgramText>& LiveMachine::program() const {
  return impl_->core->slot().text();
}
const std::string& LiveMachine::dialect() const { return impl_->core->slot().dialect(); }
std::vector<base::Diagnostic> LiveMachine::check() { return impl_->core->machine().check(); }

const std::vector<Breakpoint>& LiveMachine::breakpoints() const {
  return impl_->core->stepper().breakpoints();
}

// Memory

VariableListing LiveMachine::variables(std::optional<std::size_t> level) {
  LiveCore& core = *impl_->core;
  return core.view().variables(core.run(), level);
}

VariableListing LiveMachine::variables_named(const std::vector<std::string>& names,
                                             std::optional<std::size_t> level) {
  LiveCore& core = *impl_->core;
  return core.view().variables_named(core.run(), names, level);
}

control::Memory LiveMachine::memory() const { return impl_->core->run().memory(); }

const MachineDefinition& LiveMachine::definition() const { return impl_->core->definition(); }

MachineDefinition LiveMachine::definition_of_run() const {
  const LiveCore& core = *impl_->core;
  const bool under_way = core.is_active() || core.machine().is_in_program();
  return (under_way ? impl_->journal.start : core.run_start()).definition;
}

// Time

void LiveMachine::set_limit(const base::WorkLimit& limit) { impl_->core->set_limit(limit); }

base::Outcome<std::shared_ptr<const Snapshot>> LiveMachine::state_at(double time_s) {
  auto core = impl_->core_at(time_s);
  if (!core) return tl::unexpected(core.error());
  return std::make_shared<const Snapshot>((*core)->snapshot());
}

VariableListing LiveMachine::variables_at_state(std::optional<std::size_t> level) {
  LiveCore& core = impl_->looked_at ? *impl_->looked_at : *impl_->core;
  return core.view().variables(core.run(), level);
}

// What was done

base::Outcome<std::string> LiveMachine::journal() const {
  return journal_text({impl_->journal, impl_->core->moment()});
}

base::Outcome<LiveMachine> LiveMachine::from_journal(std::string_view journal,
                                                     std::vector<std::string> library_folders,
                                                     const Watchers& watchers,
                                                     const base::WorkLimit& limit) {
  auto read = read_journal(journal, std::move(library_folders));
  if (!read) return tl::unexpected(read.error());
  Replay replay(read->journal);
  for (motion::MotionSink* const sink : watchers.motions) replay.core().add_sink(*sink);
  for (motion::AxisPointSink* const sink : watchers.points) replay.core().add_point_sink(*sink);
  replay.core().set_limit(limit);
  replay.go_to(std::numeric_limits<double>::infinity(), read->until);
  if (limit.reached()) return refused(Refusal::takes_too_long);
  std::unique_ptr<LiveCore> core = replay.take();
  core->set_limit({});
  core->stand_for_itself();
  return LiveMachine(std::make_unique<Impl>(std::move(read->journal), std::move(core)));
}

// Teaching

namespace {

tl::unexpected<base::Failure> not_taken(const teach::Mistake& mistake) {
  const auto& text = base::text_of(mistake.code);
  const std::string message(text.message);
  return tl::unexpected(
      base::refuse_for(std::string(text.number), Refusal::taught_wrong,
                       {mistake.detail.empty() ? message : message + ": " + mistake.detail}));
}

}  // namespace

base::Outcome<LiveMachine::Taught> LiveMachine::capture(Capture what, std::string_view name) {
  LiveCore& core = *impl_->core;
  if (core.panel().mode != Mode::teach) return refused(Refusal::points_mode);
  if (core.is_active()) return refused(Refusal::points_moving);
  const base::JointPoint joints = core.run().standing_joints();
  machine::Capture& taught = impl_->capture;
  std::optional<teach::Mistake> mistake;
  switch (what) {
    case Capture::point: mistake = taught.point(joints, name); break;
    case Capture::line: mistake = taught.line(joints); break;
    case Capture::arc_via: taught.middle(joints); break;
    case Capture::arc_end: mistake = taught.arc(joints); break;
    case Capture::circle_end: mistake = taught.circle(joints); break;
  }
  if (mistake) return not_taken(*mistake);
  return this->taught();
}

base::Outcome<LiveMachine::Taught> LiveMachine::teach_record(std::string_view record) {
  if (impl_->core->panel().mode != Mode::teach) return refused(Refusal::records_mode);
  const auto parsed = teach::parse_record(teach::Words(record));
  if (!parsed) return not_taken(parsed.error());
  if (const auto mistake = impl_->capture.add(*parsed)) return not_taken(*mistake);
  return taught();
}

base::Outcome<LiveMachine::Taught> LiveMachine::take_back() {
  if (!impl_->capture.take_back()) return refused(Refusal::nothing_taught);
  return taught();
}

LiveMachine::Taught LiveMachine::taught() const {
  const teach::Recorder& recorder = impl_->capture.recorder();
  return {recorder.text(), static_cast<std::uint32_t>(recorder.records().size())};
}

void LiveMachine::new_teaching() { impl_->capture = machine::Capture(definition()); }

}  // namespace kerf::machine
