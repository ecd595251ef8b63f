#include "machine/panel/internal/live_view.hpp"

#include <algorithm>

#include "lang/vm/value.hpp"
#include "machine/panel/internal/entries.hpp"
#include "motion/spindle_speed.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kShownPrint = 4096;

std::string name_of_program(base::ProgramNumber program, const std::string& without_number) {
  const auto number = static_cast<std::uint32_t>(program);
  if (number == 0) return without_number;
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return "O" + digits;
}

std::string file_of(const PacedRun& machine, base::FileId file) {
  return machine.sources().contains(file) ? machine.sources()[file].name() : std::string();
}

AlarmText words_of(const base::Diagnostic& alarm, const PacedRun& machine) {
  const base::CodeText& text = base::text_of(alarm.code);
  AlarmText words;
  words.code = alarm.number;
  words.message = alarm.message;
  words.program = alarm.program;
  words.file = file_of(machine, alarm.place.file);
  words.line = alarm.place.line;
  words.column = alarm.place.column;
  words.length = alarm.place.length;
  words.cause = text.cause;
  words.remedy = text.remedy;
  return words;
}

using Seen = LiveView::Seen;

// While axes move: where they are; at rest: where the control is.
void show_place(const Seen& seen, Snapshot& shown) {
  PacedRun& machine = seen.run.machine();
  const motion::Mark& mark = seen.run.last().mark;
  const base::Place standing = machine.control().standing_at();
  const bool by_mark = seen.run.is_active() && mark.motion != 0 && mark.block.line != 0;
  const base::FileId file = by_mark ? mark.block.file : standing.file;
  shown.line = by_mark ? mark.block.line : standing.line;
  shown.file = file_of(machine, file);
  if (machine.sources().contains(file))
    shown.text = seen.run.lines().text(machine.sources()[file], file, shown.line);
  if (by_mark) {
    shown.program = name_of_program(mark.block.program, machine.program_name());
  } else if (machine.is_in_program() || machine.alarm()) {
    shown.program = machine.control().running_program();
  } else if (seen.has_program) {
    shown.program = machine.program_name();
  }
}

// In a rapid the spindle has the speed of its end.
double rpm_now(const Seen& seen, const BlockState& state) {
  if (state.held_rpm > 0) return state.held_rpm;
  const motion::Setpoint& at = seen.run.last();
  const bool rapid = seen.run.block_made() != nullptr && at.mark.kind == motion::MoveKind::rapid;
  return motion::rpm_at(state.spindle, rapid ? seen.run.source().motion_end() : at.tip);
}

void show_spindle(const Seen& seen, const BlockState& state, Snapshot& shown) {
  const motion::Spindle& spindle = state.spindle;
  shown.spindle = spindle.turning;
  if (spindle.mode == motion::Spindle::Mode::constant_surface_speed) {
    shown.surface_m_min = spindle.speed;
    shown.spindle_limit_rpm = spindle.limit_rpm();
  }
  if (spindle.turning != motion::Spindle::Turning::stopped)
    shown.spindle_rpm = rpm_now(seen, state) * seen.panel.dials.spindle / 100;
}

void show_functions(const Seen& seen, Snapshot& shown) {
  PacedRun& machine = seen.run.machine();
  const motion::Mark& mark = seen.run.last().mark;
  const BlockState* const made = seen.run.block_made();
  const bool moving = made != nullptr;
  const BlockState& state = moving ? *made : seen.run.trail().newest();
  show_spindle(seen, state, shown);
  shown.modal = machine.control().modal_text(state.modal);
  shown.coolant = state.coolant;
  shown.tool = state.tool;
  shown.tool_offset = state.modal.tool_offset;
  const int dial = seen.panel.dials.spindle;
  shown.power_percent = std::min(100.0, state.power.percent * dial / 100);
  // Where the axes rest on their way it would burn a hole.
  const bool rests = machine.servo().held() || machine.servo().at_rest();
  const bool dwells = mark.kind == motion::MoveKind::dwell && mark.power_follows_speed;
  shown.beam = moving && !rests && !dwells && mark.power_percent > 0;
  shown.feed_programmed_mm_min = moving ? 60.0 * static_cast<double>(mark.speed) : 0;
  shown.feed_mm_rev = moving && mark.kind == motion::MoveKind::cut ? state.feed_mm_rev : 0;
  shown.feed_actual_mm_min = moving ? 60 * machine.servo().speed() : 0;
}

void show_positions(const Seen& seen, Snapshot& shown) {
  const motion::Setpoint& at = seen.run.last();
  const BlockState* const made = seen.run.block_made();
  const bool moving = made != nullptr;
  const BlockState& state = moving ? *made : seen.run.trail().newest();
  shown.machine = machine_of(at.tip, state.tool_length);
  shown.work = at.tip.numbers() - state.origin;
  if (moving && at.mark.kind != motion::MoveKind::dwell)
    shown.distance = seen.run.source().motion_end() - at.tip;
  shown.joints = seen.run.standing_joints();
}

void show_alarm(const Seen& seen, Snapshot& shown) {
  const PacedRun& machine = seen.run.machine();
  if (machine.alarm()) {
    shown.alarm = words_of(*machine.alarm(), machine);
  } else if (seen.console.alarm()) {
    shown.alarm = words_of(*seen.console.alarm(), machine);
  }
}

void show_stack(const Seen& seen, Snapshot& shown) {
  PacedRun& machine = seen.run.machine();
  if (seen.run.is_active() ? !seen.run.is(Activity::program)
                           : !machine.is_in_program() && !machine.alarm())
    return;
  const BlockState* const made = seen.run.block_made();
  for (const control::OpenCall& call : made ? made->calls : machine.control().open_calls())
    shown.stack.push_back(
        {call.program, file_of(machine, call.block.file), call.block.line, shown.stack.size()});
  if (made == nullptr || shown.stack.empty()) return;
  shown.stack.back().file = shown.file;
  shown.stack.back().line = shown.line;
}

void show_console(const Console& console, Snapshot& shown) {
  const std::string& printed = console.printed();
  shown.messages.assign(console.messages().begin(), console.messages().end());
  shown.printed =
      printed.size() > kShownPrint ? printed.substr(printed.size() - kShownPrint) : printed;
  shown.printed_bytes = console.printed_bytes();
}

}  // namespace

Status status_of(const LiveRun& run, const Console& console) {
  const PacedRun& machine = run.machine();
  if (console.alarm() || machine.alarm()) return Status::alarm;
  if (run.is_active()) {
    if (!machine.servo().held()) return Status::running;
    if (run.is_feed_held()) return Status::held;
    if (run.is_held_behind_block()) return run.was_stepping ? Status::step : Status::stopped;
    return Status::running;
  }
  if (machine.is_in_program())
    return machine.halt() == control::Halt::gate ? Status::step : Status::stopped;
  return machine.status() == RunStatus::end ? Status::end : Status::idle;
}

Snapshot LiveView::snapshot(const Seen& seen) const {
  Snapshot shown;
  shown.status = status_of(seen.run, seen.console);
  shown.panel = seen.panel;
  shown.time_s = seen.run.time_s();
  shown.run = seen.run.number();
  shown.motion = seen.run.last().mark.motion;
  shown.motions = seen.run.trail().motions();
  show_place(seen, shown);
  show_functions(seen, shown);
  show_positions(seen, shown);
  show_alarm(seen, shown);
  show_stack(seen, shown);
  show_console(seen.console, shown);
  shown.variables_revision = variables_revision(seen.run);
  shown.waits_for_input = seen.run.machine().waits_for_input();
  shown.inputs = seen.run.machine().signals().inputs();
  if (shown.status == Status::step) shown.breakpoint = seen.stepper.hit();
  return shown;
}

// Even numbers while the axes rest, odd ones on the way.
std::uint64_t LiveView::variables_revision(LiveRun& run) const {
  const BlockState* const made = run.image_made();
  const std::uint64_t revision =
      made ? 2 * made->variables_revision + 1 : 2 * run.machine().control().blocks();
  return revision + (changes_ << 40U);
}

LiveView::Values LiveView::values(LiveRun& run) {
  Values all;
  Dialect& language = run.machine().language();
  const std::size_t levels = std::max<std::size_t>(run.machine().control().open_calls().size(), 1);
  std::vector<double> numbers;
  language.variables().read(numbers);
  for (std::size_t level = 0; level < levels; ++level) {
    bool any_local = false;
    for (const VariableRow& row : language.variables().list(numbers, level).rows) {
      const bool local = row.scope == VariableScope::local;
      any_local |= local;
      all[{row.name, local ? level : 0}] = row.value;
    }
    if (!any_local) break;  // every level shows the same
  }
  return all;
}

void LiveView::note_start(LiveRun& run) { before_ = at_stop_ = values(run); }

void LiveView::note_stop(LiveRun& run) { before_ = std::exchange(at_stop_, values(run)); }

VariableListing LiveView::variables_named(LiveRun& run, const std::vector<std::string>& names,
                                          std::optional<std::size_t> level) const {
  return run.at_block_made([&] { return list_named(run, names, level); });
}

VariableListing LiveView::variables(LiveRun& run, std::optional<std::size_t> level) const {
  return run.at_block_made([&] { return list(run, level); });
}

VariableListing LiveView::list_named(LiveRun& run, const std::vector<std::string>& names,
                                     std::optional<std::size_t> level) const {
  const VariableListing all = list(run, level);
  ProgramVariables& variables = run.machine().language().variables();
  VariableListing listing{{}, all.scopes, all.levels};
  const std::size_t wanted = level.value_or(innermost(all.levels));
  for (const std::string& name : names) {
    const auto listed = std::find_if(all.rows.begin(), all.rows.end(),
                                     [&](const VariableRow& row) { return row.name == name; });
    if (listed != all.rows.end()) {
      listing.rows.push_back(*listed);
    } else if (run.image_made() != nullptr && variables.is_listed(name)) {
      listing.rows.push_back({name, "", vm::kNull, VariableScope::program, wanted, false});
    } else if (const auto value = variables.value(name, wanted)) {
      listing.rows.push_back({name, "", *value, VariableScope::program, wanted, false});
    }
  }
  return listing;
}

VariableListing LiveView::list(LiveRun& run, std::optional<std::size_t> level) const {
  const BlockState* const made = run.image_made();
  ProgramVariables& variables = run.machine().language().variables();
  std::vector<double> numbers;
  if (made) {
    numbers = made->variables->values();
  } else {
    variables.read(numbers);
  }
  const std::size_t levels =
      made ? made->calls.size() : run.machine().control().open_calls().size();
  VariableListing listing = variables.list(numbers, level.value_or(innermost(levels)));
  listing.levels = levels;
  for (VariableRow& row : listing.rows) {
    const bool local = row.scope == VariableScope::local;
    const auto found = before_.find({row.name, local ? row.level : 0});
    const double before = found == before_.end() ? vm::kNull : found->second;
    row.changed = before != row.value && !(vm::is_null(before) && vm::is_null(row.value));
  }
  return listing;
}

}  // namespace kerf::machine
