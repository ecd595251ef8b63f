#include "machine/panel/live_machine.hpp"

#include <cmath>
#include <limits>

#include "lang/teach/record_parser.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/panel/internal/forecast.hpp"
#include "machine/panel/internal/journal.hpp"
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

  using Act = Journal::Act;
  /// Does what the operator asks for, and remembers it.
  Outcome perform(const Act& act);
  /// Likewise, where the program has been read farther than the axes are: `effect` comes before the
  /// first block that they have not begun, `to_show` now; where that cannot be, `act` now.
  Outcome perform_at_axes(const Act& act, const Act& to_show, const Act& effect);
  /// Likewise; a run begins with it.
  Outcome begin(const Act& act);
  /// Likewise, where axes moved by hand begin one.
  Outcome move_by_hand(const Act& act) {
    return core->would_begin_by_hand() ? begin(act) : perform(act);
  }
  /// Likewise, where cycle start would begin the program.
  Outcome set_off(const Act& act) { return core->would_begin() ? begin(act) : perform(act); }
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
      journal{core->run_start(), 0, {}},
      capture(definition) {}

LiveMachine::Outcome LiveMachine::Impl::perform(const Act& act) {
  const LiveCore::Moment now = core->moment();
  Outcome done = act(*core);
  if (done) journal.entries.push_back({now, act, {}, {}});
  touch();
  return done;
}

LiveMachine::Outcome LiveMachine::Impl::perform_at_axes(const Act& act, const Act& to_show,
                                                        const Act& effect) {
  auto again = read_again(journal, *core, to_show, effect);
  if (!again) return perform(act);
  again->core->replace(*core);
  put(std::move(again->core));
  journal = std::move(again->journal);
  touch();
  return {};
}

// The points that follow go on where the last ones ended.
void LiveMachine::Impl::put(std::unique_ptr<LiveCore> other) {
  for (motion::MotionSink* const sink : sinks) other->add_sink(*sink);
  for (motion::AxisPointSink* const sink : point_sinks) other->add_point_sink(*sink);
  other->set_limit(core->limit());
  core = std::move(other);
}

LiveMachine::Outcome LiveMachine::Impl::begin(const Act& act) {
  RunStart start = core->run_start();
  const std::uint64_t run = core->run();
  Outcome done = act(*core);
  if (done) {
    journal = {std::move(start), run, {}};
    journal.entries.push_back({{}, act, {}, {}});
  } else if (core->points() == 0) {
    journal = {core->run_start(), core->run(), {}};  // what was tried has begun anew
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
  for (std::size_t i = 0; i < kept; ++i) {
    const auto& ahead = journal.entries[i].ahead;
    if (ahead && ahead->block > done) static_cast<void>(ahead->act(*there));
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
    forecast = std::make_unique<Forecast>(core->would_begin() ? core->run_start() : journal.start);
  forecast->core().set_limit(core->limit());
  forecast->go_to(time_s);
  return &forecast->core();
}

LiveMachine::LiveMachine(const MachineDefinition& definition, control::Memory memory,
                         Settings settings)
    : impl_(std::make_unique<Impl>(definition, std::move(memory), std::move(settings))) {}
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

void LiveMachine::raise(const base::Diagnostic& alarm) {
  static_cast<void>(impl_->perform([alarm](LiveCore& core) {
    core.raise(alarm);
    return Outcome{};
  }));
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

LiveMachine::Outcome LiveMachine::load(base::ProgramText program, std::string dialect) {
  return impl_->begin([program = std::move(program), dialect = std::move(dialect)](LiveCore& core) {
    return core.load(program, dialect);
  });
}

LiveMachine::Outcome LiveMachine::can_load(const base::ProgramText& program,
                                           const std::string& dialect) const {
  return impl_->core->can_load(program, dialect);
}

const std::optional<base::ProgramText>& LiveMachine::program() const {
  return impl_->core->program();
}
const std::string& LiveMachine::dialect() const { return impl_->core->dialect(); }
std::vector<base::Diagnostic> LiveMachine::check() { return impl_->core->machine().check(); }

// The panel

LiveMachine::Outcome LiveMachine::set_mode(Mode mode) {
  return impl_->perform([mode](LiveCore& core) { return core.set_mode(mode); });
}

LiveMachine::Outcome LiveMachine::cycle_start() {
  return impl_->set_off([](LiveCore& core) { return core.cycle_start(); });
}

LiveMachine::Outcome LiveMachine::feed_hold() {
  return impl_->perform([](LiveCore& core) { return core.feed_hold(); });
}

void LiveMachine::reset() {
  const auto act = [](LiveCore& core) {
    core.reset();
    return Outcome{};
  };
  static_cast<void>(impl_->core->is_broken_off() ? impl_->begin(act) : impl_->perform(act));
}

LiveMachine::Outcome LiveMachine::set_switch(Switch which, bool on) {
  const auto act = [which, on](LiveCore& core) { return core.set_switch(which, on); };
  return which == Switch::machine_lock ? impl_->begin(act) : impl_->perform(act);
}

LiveMachine::Outcome LiveMachine::set_block_skip(std::uint32_t levels) {
  const auto act = [levels](LiveCore& core) { return core.set_block_skip(levels); };
  LiveCore& core = *impl_->core;
  if (!core.is_ahead() || core.begun().slashes == core.read().slashes) return impl_->perform(act);
  if (auto checked = LiveCore::check_skip_levels(levels); !checked) return checked;
  return impl_->perform_at_axes(
      act, [levels](LiveCore& at) { return at.show_block_skip(levels); },
      [levels](LiveCore& at) { return at.apply_block_skip(levels); });
}

LiveMachine::Outcome LiveMachine::interrupt() {
  const auto act = [](LiveCore& core) { return core.interrupt(); };
  if (!impl_->core->is_ahead()) return impl_->perform(act);
  return impl_->perform_at_axes(act, {}, act);
}

LiveMachine::Outcome LiveMachine::set_input(const std::string& name, double value) {
  return impl_->perform([=](LiveCore& core) { return core.set_input(name, value); });
}

LiveMachine::Outcome LiveMachine::set_dials(const OverrideDials& dials) {
  return impl_->perform([dials](LiveCore& core) { return core.set_dials(dials); });
}

LiveMachine::Outcome LiveMachine::jog(std::string_view axis, double speed_per_min) {
  return impl_->move_by_hand([axis = std::string(axis), speed_per_min](LiveCore& core) {
    return core.jog(axis, speed_per_min);
  });
}

LiveMachine::Outcome LiveMachine::jog_by(std::string_view axis, double distance,
                                         double speed_per_min) {
  return impl_->move_by_hand([axis = std::string(axis), distance, speed_per_min](LiveCore& core) {
    return core.jog_by(axis, distance, speed_per_min);
  });
}

LiveMachine::Outcome LiveMachine::jog_stop() {
  return impl_->perform([](LiveCore& core) { return core.jog_stop(); });
}

LiveMachine::Outcome LiveMachine::home() {
  return impl_->perform([](LiveCore& core) { return core.home(); });
}

LiveMachine::Outcome LiveMachine::mdi(std::string text) {
  return impl_->perform([text = std::move(text)](LiveCore& core) { return core.mdi(text); });
}

LiveMachine::Outcome LiveMachine::enter(std::string line) {
  return impl_->perform([line = std::move(line)](LiveCore& core) { return core.enter(line); });
}

// Stepping

LiveMachine::Outcome LiveMachine::step(Step how) {
  return impl_->set_off([how](LiveCore& core) { return core.step(how); });
}

LiveMachine::Outcome LiveMachine::step_back() { return impl_->step_back(); }

LiveMachine::Outcome LiveMachine::run_to(std::string file, std::uint32_t line) {
  return impl_->set_off(
      [file = std::move(file), line](LiveCore& core) { return core.run_to(file, line); });
}

LiveMachine::Outcome LiveMachine::start_at(std::uint32_t line) {
  return impl_->begin([line](LiveCore& core) { return core.start_at(line); });
}

LiveMachine::Outcome LiveMachine::set_breakpoints(std::vector<Breakpoint> breakpoints) {
  return impl_->perform([breakpoints = std::move(breakpoints)](LiveCore& core) {
    return core.set_breakpoints(breakpoints);
  });
}

const std::vector<Breakpoint>& LiveMachine::breakpoints() const {
  return impl_->core->stepper().breakpoints();
}

// Memory

VariableListing LiveMachine::variables(std::optional<std::size_t> level) {
  return impl_->core->variables(level);
}

VariableListing LiveMachine::variables_named(const std::vector<std::string>& names,
                                             std::optional<std::size_t> level) {
  return impl_->core->variables_named(names, level);
}

LiveMachine::Outcome LiveMachine::set_variable(const std::string& name, std::optional<double> value,
                                               std::optional<std::size_t> level) {
  LiveCore& core = *impl_->core;
  const auto act = [=](LiveCore& at) { return at.set_variable(name, value, level); };
  if (!core.is_ahead() || !core.stands() || core.machine().language().variables().is_input(name))
    return impl_->perform(act);
  const std::size_t wanted = level.value_or(core.shown_level());
  return impl_->perform_at_axes(
      act, [=](LiveCore& at) { return at.show_variable(name, value, wanted); },
      [=](LiveCore& at) { return at.enter_variable(name, value, wanted); });
}

LiveMachine::Outcome LiveMachine::set_offset(const std::string& offset, std::string_view axis,
                                             double value) {
  return impl_->perform([offset, axis = std::string(axis), value](LiveCore& core) {
    return core.set_offset(offset, axis, value);
  });
}

control::Memory LiveMachine::memory() const { return impl_->core->memory(); }

void LiveMachine::set_memory(control::Memory memory) {
  static_cast<void>(impl_->perform([memory = std::move(memory)](LiveCore& core) {
    core.set_memory(memory);
    return Outcome{};
  }));
}

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
  return (impl_->looked_at ? *impl_->looked_at : *impl_->core).variables(level);
}

// Teaching

namespace {

tl::unexpected<base::Failure> refused(const teach::Mistake& mistake) {
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
  const base::JointPoint joints = core.standing_joints();
  machine::Capture& taught = impl_->capture;
  std::optional<teach::Mistake> mistake;
  switch (what) {
    case Capture::point: mistake = taught.point(joints, name); break;
    case Capture::line: mistake = taught.line(joints); break;
    case Capture::arc_via: taught.middle(joints); break;
    case Capture::arc_end: mistake = taught.arc(joints); break;
    case Capture::circle_end: mistake = taught.circle(joints); break;
  }
  if (mistake) return refused(*mistake);
  return this->taught();
}

base::Outcome<LiveMachine::Taught> LiveMachine::teach_record(std::string_view record) {
  if (impl_->core->panel().mode != Mode::teach) return refused(Refusal::records_mode);
  const auto parsed = teach::parse_record(teach::Words(record));
  if (!parsed) return refused(parsed.error());
  if (const auto mistake = impl_->capture.add(*parsed)) return refused(*mistake);
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
