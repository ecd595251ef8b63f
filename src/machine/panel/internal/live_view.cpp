// What is to be seen of a live machine.
#include <algorithm>
#include <cmath>

#include "lang/vm/value.hpp"
#include "machine/panel/internal/live_core.hpp"

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

}  // namespace

Status LiveCore::status() const {
  if (panel_alarm_ || machine_->alarm()) return Status::alarm;
  if (is_active()) {
    if (!machine_->servo().source().held()) return Status::running;
    if (feed_hold_) return Status::held;
    if (block_hold_) return was_stepping_ ? Status::step : Status::stopped;
    return Status::running;
  }
  if (machine_->is_in_program())
    return machine_->halt() == control::Halt::gate ? Status::step : Status::stopped;
  return machine_->status() == RunStatus::end ? Status::end : Status::idle;
}

// While axes move: where they are; at rest: where the control is.
void LiveCore::show_place(Snapshot& shown) {
  control::Control& control = machine_->control();
  const motion::Mark& mark = machine_->servo().last().mark;
  const base::Place standing = control.standing_at();
  const bool by_mark = is_active() && mark.motion != 0 && mark.block.line != 0;
  const base::FileId file = by_mark ? mark.block.file : standing.file;
  shown.line = by_mark ? mark.block.line : standing.line;
  shown.file = file_of(*machine_, file);
  if (machine_->sources().contains(file))
    shown.text = lines_.text(machine_->sources()[file], file, shown.line);
  if (by_mark) {
    shown.program = name_of_program(mark.block.program, machine_->program_name());
  } else if (machine_->is_in_program() || machine_->alarm()) {
    shown.program = control.running_program();
  } else if (program_) {
    shown.program = machine_->program_name();
  }
}

// What the control showed with the motion that is being made; null: none is.
const BlockState* LiveCore::block_made() {
  const motion::Mark& mark = machine_->servo().last().mark;
  return is_active() && mark.motion != 0 ? &trail_->at(mark.motion) : nullptr;
}

void LiveCore::show_functions(Snapshot& shown) {
  const motion::Mark& mark = machine_->servo().last().mark;
  const BlockState* const made = block_made();
  const bool moving = made != nullptr;
  const BlockState& state = moving ? *made : trail_->newest();
  shown.modal = machine_->control().modal_text(state.modal);
  shown.spindle = state.spindle.turning;
  if (state.spindle.turning != motion::Spindle::Turning::stopped)
    shown.spindle_rpm = state.spindle.speed * panel_.dials.spindle / 100;
  shown.coolant = state.coolant;
  shown.tool = state.tool;
  shown.power_percent = std::min(100.0, state.power.percent * panel_.dials.spindle / 100);
  // Where the axes rest on their way it would burn a hole.
  const bool rests = machine_->servo().source().held() || machine_->servo().at_rest();
  const bool dwells = mark.kind == motion::MoveKind::dwell && mark.power_follows_speed;
  shown.beam = moving && !rests && !dwells && mark.power_percent > 0;
  shown.feed_programmed_mm_min = moving ? 60.0 * static_cast<double>(mark.speed) : 0;
  shown.feed_actual_mm_min = moving ? 60 * machine_->servo().speed() : 0;
}

void LiveCore::show_positions(Snapshot& shown) {
  const motion::Setpoint& at = machine_->servo().last();
  const BlockState* const made = block_made();
  const bool moving = made != nullptr;
  const BlockState& state = moving ? *made : trail_->newest();
  shown.machine = machine_of(at.tip, state.tool_length);
  shown.work = at.tip.numbers() - state.origin;
  if (moving && at.mark.kind != motion::MoveKind::dwell)
    shown.distance = machine_->servo().source().motion_end() - at.tip;
  shown.joints = standing_joints();
}

void LiveCore::show_alarm(Snapshot& shown) const {
  if (machine_->alarm()) {
    shown.alarm = words_of(*machine_->alarm(), *machine_);
  } else if (panel_alarm_) {
    shown.alarm = words_of(*panel_alarm_, *machine_);
  }
}

void LiveCore::show_stack(Snapshot& shown) {
  if (is_active() ? activity_ != Activity::program
                  : !machine_->is_in_program() && !machine_->alarm())
    return;
  const BlockState* const made = block_made();
  for (const control::OpenCall& call : made ? made->calls : machine_->control().open_calls())
    shown.stack.push_back(
        {call.program, file_of(*machine_, call.block.file), call.block.line, shown.stack.size()});
  if (made == nullptr || shown.stack.empty()) return;
  shown.stack.back().file = shown.file;
  shown.stack.back().line = shown.line;
}

Snapshot LiveCore::snapshot() {
  Snapshot shown;
  shown.status = status();
  shown.panel = panel_;
  shown.time_s = time_s();
  shown.run = run_;
  shown.motion = machine_->servo().last().mark.motion;
  shown.motions = trail_->motions();
  show_place(shown);
  show_functions(shown);
  show_positions(shown);
  show_alarm(shown);
  show_stack(shown);
  shown.messages.assign(messages_.begin(), messages_.end());
  // Even numbers while the axes rest, odd ones on the way.
  const BlockState* const made = image_made();
  const std::uint64_t revision =
      made ? 2 * made->variables_revision + 1 : 2 * machine_->control().blocks();
  shown.variables_revision = revision + (changes_ << 40U);
  shown.printed =
      printed_.size() > kShownPrint ? printed_.substr(printed_.size() - kShownPrint) : printed_;
  shown.printed_bytes = printed_bytes_;
  shown.waits_for_input = machine_->waits_for_input();
  shown.inputs = machine_->signals().inputs();
  if (shown.status == Status::step) shown.breakpoint = stepper_->hit();
  return shown;
}

LiveCore::Values LiveCore::values() {
  Values all;
  Dialect& language = machine_->language();
  const std::size_t levels = std::max<std::size_t>(machine_->control().open_calls().size(), 1);
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

VariableListing LiveCore::variables_named(const std::vector<std::string>& names,
                                          std::optional<std::size_t> level) {
  return at_block_made([&] { return list_named(names, level); });
}

VariableListing LiveCore::variables(std::optional<std::size_t> level) {
  return at_block_made([&] { return list_variables(level); });
}

VariableListing LiveCore::list_named(const std::vector<std::string>& names,
                                     std::optional<std::size_t> level) {
  const VariableListing all = list_variables(level);
  VariableListing listing{{}, all.scopes, all.levels};
  const std::size_t levels = all.levels;
  const std::size_t wanted = level.value_or(levels == 0 ? 0 : levels - 1);
  for (const std::string& name : names) {
    const auto listed = std::find_if(all.rows.begin(), all.rows.end(),
                                     [&](const VariableRow& row) { return row.name == name; });
    if (listed != all.rows.end()) {
      listing.rows.push_back(*listed);
    } else if (image_made() != nullptr && machine_->language().variables().is_listed(name)) {
      listing.rows.push_back({name, "", vm::kNull, VariableScope::program, wanted, false});
    } else if (const auto value = machine_->language().variables().value(name, wanted)) {
      listing.rows.push_back({name, "", *value, VariableScope::program, wanted, false});
    }
  }
  return listing;
}

VariableListing LiveCore::list_variables(std::optional<std::size_t> level) {
  const BlockState* const made = image_made();
  std::vector<double> numbers;
  if (made) {
    numbers = made->variables->values();
  } else {
    machine_->language().variables().read(numbers);
  }
  const std::size_t levels = made ? made->calls.size() : machine_->control().open_calls().size();
  const std::size_t innermost = levels == 0 ? 0 : levels - 1;
  VariableListing listing =
      machine_->language().variables().list(numbers, level.value_or(innermost));
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
