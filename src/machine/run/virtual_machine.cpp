#include "machine/run/virtual_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "base/program_name.hpp"
#include "kinematics/fault.hpp"
#include "machine/dialect/language.hpp"
#include "machine/run/internal/reach.hpp"

namespace kerf::machine {
namespace {

using control::Halt;

// Instructions between two looks at the clock: some milliseconds.
constexpr std::uint64_t kSlice = 200'000;

}  // namespace

VirtualMachine::VirtualMachine(const MachineDefinition& definition, control::Memory memory,
                               const Settings& settings)
    : definition_(definition),
      memory_(std::move(memory)),
      statistics_(definition_.axes),
      spindle_beam_(definition_.drive.laser),
      dotted_cut_(definition_.drive.laser),
      dialect_name_(settings.dialect.empty() ? definition.dialect : settings.dialect),
      servo_(definition_,
             dialect_name_ == kPatternDialect && !settings.by_hand ? &records_ : nullptr) {
  if (definition_.axes.linked)
    reach_ = std::make_unique<Reach>(servo_.kinematics(), definition_.axes, definition_.start);
  dialect_ = make_dialect(dialect_name_, {definition_, memory_, sources_, signals_, *this, *this,
                                          settings.pages, records_});
}

VirtualMachine::~VirtualMachine() = default;

void VirtualMachine::load(std::unique_ptr<base::SourceFile> file) {
  dialect_->load(sources_.add(std::move(file)));
}

void VirtualMachine::raise(const base::Diagnostic& alarm) {
  if (!drive_alarm_) drive_alarm_ = alarm;
  servo_.break_off();
}

void VirtualMachine::refuse(const base::Diagnostic& alarm) {
  refused_ = true;
  servo_.finish();
  if (!drive_alarm_ && !servo_.broken_off()) drive_alarm_ = alarm;
}

// Behind the budget or a refused motion, and where the axes stopped on their own, the control is
// some moves ahead of the machine.
base::AxisVector VirtualMachine::position() const {
  if (servo_.broken_off()) return servo_.last().tip + dialect_->control().tool_length();
  if (!motions_spent_ && !refused_) return dialect_->control().machine_position();
  return statistics_.at() + dialect_->control().tool_length();
}

bool VirtualMachine::axes_have_arrived() {
  if (diverted_ != nullptr || (is_paced_ && servo_.at_rest())) return true;
  servo_.finish();
  return !is_paced_;
}

bool VirtualMachine::input_can_be_read() {
  waits_for_input_ = is_paced_ && input_ready_ && !input_ready_();
  return !waits_for_input_;
}

std::uint32_t VirtualMachine::inputs(std::size_t word) {
  input_wait_.read(servo_.time_s());
  return signals_.inputs(word);
}

double VirtualMachine::seconds() {
  if (!is_paced_) servo_.finish();
  return servo_.time_s();
}

std::optional<control::Refusal> VirtualMachine::refusal(const base::AxisVector& from,
                                                        const motion::Motion& move, Intent intent) {
  if (!reach_) return std::nullopt;
  base::AxisVector end;
  if (auto fault = reach_->objection(from, move, end))
    return control::Refusal{kinematics::code_of(fault->kind), std::move(fault->message)};
  if (intent == Intent::make) {
    reach_->set_joints(end);
    look_for_caution(move);
  }
  return std::nullopt;
}

// Of the move that was followed last.
void VirtualMachine::look_for_caution(const motion::Motion& move) {
  const bool cuts = std::holds_alternative<motion::Line>(move.action) ||
                    std::holds_alternative<motion::Arc>(move.action) ||
                    std::holds_alternative<motion::SpaceArc>(move.action);
  if (near_singular_ || !cuts || !reach_->caution()) return;
  const auto& [sentence, tip] = *reach_->caution();
  near_singular_ = base::make_error(
      base::Code::singular, {.file = move.file, .line = move.line, .column = 1},
      fmt::format("near X{:.6g} Y{:.6g} {}", base::tidy(tip[*definition_.axes.find('X')]),
                  base::tidy(tip[*definition_.axes.find('Y')]), sentence));
  near_singular_->program = base::program_name(static_cast<std::uint32_t>(move.program));
  near_singular_->severity = base::Severity::warning;
}

// Contacts are used up in order: the next one waits until a probing move passes it.
std::optional<double> VirtualMachine::contact(const base::AxisVector& from,
                                              const base::AxisVector& to) {
  if (contacts_.empty()) return std::nullopt;
  const SkipContact& next = contacts_.front();
  const double begin = from[next.axis];
  const double end = to[next.axis];
  const bool passed = (begin <= next.machine && next.machine <= end) ||
                      (end <= next.machine && next.machine <= begin);
  if (!passed) return std::nullopt;
  const double fraction = begin == end ? 0 : (next.machine - begin) / (end - begin);
  contacts_.pop_front();
  return fraction;
}

void VirtualMachine::print(std::string_view text) {
  if (print_output_) print_output_(text);
}

bool VirtualMachine::all_motions_made() const {
  return most_motions_ != 0 && statistics_.motions() >= most_motions_;
}

// A block may make any number of motions: between them the clock is looked at, too.
bool VirtualMachine::ready() const {
  if (diverted_ != nullptr) return true;
  if (is_paced_) return servo_.has_room() && !servo_.broken_off();
  if (!input_waits_ && input_wait_.waits()) return false;
  return !motions_spent_ && !refused_ && !servo_.broken_off() && !limit_.unwanted() &&
         statistics_.motions() < slice_end_;
}

// Where the axes were moved by hand the program finds its beam as it left it.
void VirtualMachine::take(const motion::Motion& motion) {
  for (const motion::Motion& each : spindle_beam_.translated(motion)) {
    if (const auto* const power = std::get_if<motion::Power>(&each.action)) beam_ = *power;
    if (motion::target_of(each) != nullptr) switch_beam(beam_, each);
    make(each);
  }
}

void VirtualMachine::switch_beam(const motion::Power& power, const motion::Motion& move) {
  if (power == made_beam_) return;
  motion::Motion motion = move;
  motion.action = power;
  make(motion);
}

// Beyond the budget nothing is handed out any more. What moves nothing may still follow its last
// motion: above all the end of the program.
void VirtualMachine::make(const motion::Motion& motion) {
  if (diverted_ != nullptr) {
    diverted_->take(motion);
    return;
  }
  motions_spent_ |= all_motions_made() && motion::target_of(motion) != nullptr;
  if (motions_spent_ || refused_) return;
  if (motion::target_of(motion) != nullptr) input_wait_.moved();
  if (judge_ != nullptr) judge_->take(motion);
  if (refused_) return;
  if (const auto* const power = std::get_if<motion::Power>(&motion.action)) made_beam_ = *power;
  statistics_.take(motion);
  dotted_cut_.take(motion);
  servo_.take(alter_ ? alter_(motion) : motion);
  for (motion::MotionSink* const sink : sinks_) sink->take(motion);
  ++handed_out_;
}

std::vector<base::Diagnostic> VirtualMachine::warnings() const {
  std::vector<base::Diagnostic> list;
  for (const auto& warning : {spindle_beam_.warning(), spindle_beam_.dwell_warning(),
                              dotted_cut_.warning(), near_singular_}) {
    if (warning) list.push_back(*warning);
  }
  return list;
}

void VirtualMachine::check(base::Findings& found) {
  dialect_->check(found);
  if (!found.cut_short()) return;
  base::Diagnostic warning =
      base::make_error(base::Code::budget_spent, {}, words_for(found.limit()));
  warning.severity = base::Severity::warning;
  warning.place.file = dialect_->main_file();
  warning.program = program_name();
  found.conclude(std::move(warning));
}

std::vector<base::Diagnostic> VirtualMachine::check() {
  base::Findings found;
  check(found);
  return found.list();
}

bool VirtualMachine::start_program() {
  alarm_ = dialect_->start();
  if (alarm_ && alarm_->program.empty()) alarm_->program = program_name();
  if (!alarm_ || !search_) return !alarm_;
  note_alarm(*alarm_);
  return !dialect_->start_all_the_same();
}

// Behind its alarms

void VirtualMachine::search_alarms() {
  search_.emplace();
  control().allow_passing();
}

// The axes come to rest, as they would where the control stops.
void VirtualMachine::note_alarm(const base::Diagnostic& alarm) {
  if (!search_->any()) {
    servo_.finish();
    search_->stopped_at({handed_out_, servo_.time_s()});
    alarm_ = alarm;
    search_steps_ = 0;
  }
  search_->add(alarm);
}

bool VirtualMachine::passes_alarm() {
  if (!search_ || servo_.broken_off()) return false;
  if (const auto& alarm = control().alarm()) note_alarm(*alarm);
  return !search_->is_cut_short() && control().pass_alarm();
}

// A halt has its reason, of which there are not so many; without one all steps were made.
bool VirtualMachine::search_is_over(std::uint64_t steps) {
  if (!search_ || !search_->any()) return false;
  search_steps_ += steps;
  if (search_steps_ < AlarmSearch::kMostSteps) return false;
  search_->cut_short();
  return true;
}

VirtualMachine::Status VirtualMachine::end_search() {
  if (search_->is_cut_short()) note_spent("there is more behind its alarms, not looked at");
  servo_.finish();
  return status_ = servo_.broken_off() ? broken_off(Status::alarm) : Status::alarm;
}

VirtualMachine::Status VirtualMachine::finish(Status status) {
  if (search_ && search_->any()) return end_search();
  if (status == Status::alarm && !alarm_) alarm_ = control().alarm();
  servo_.finish();
  return status_ = servo_.broken_off() || refused_ ? broken_off(status) : status;
}

// What the drives could not do comes before all that the control has met since.
VirtualMachine::Status VirtualMachine::broken_off(Status status) {
  if (drive_alarm_) {
    alarm_ = drive_alarm_;
    return Status::alarm;
  }
  note_spent(words_for(limit_));
  return status == Status::alarm ? status : Status::budget;
}

void VirtualMachine::note_spent(const std::string& what, base::Code code) {
  notice_ = base::make_error(code, control().standing_at(), what);
  notice_->severity = base::Severity::warning;
  notice_->program = control().running_program();
}

VirtualMachine::Status VirtualMachine::spent(const std::string& what) {
  note_spent(what);
  return finish(Status::budget);
}

VirtualMachine::Status VirtualMachine::waits_for_signal() {
  note_spent("it moves nothing, and only reads inputs", base::Code::waits_for_input);
  return finish(Status::budget);
}

// One motion may have any number of set-points: between them the clock is looked at, too.
void VirtualMachine::watch_clock(const base::WorkLimit& limit) {
  limit_ = limit;
  servo_.break_off_when([this] {
    if (progress_) progress_();
    return limit_.reached();
  });
}

std::string VirtualMachine::words_for(const base::WorkLimit& limit) {
  if (limit.unwanted()) return "nobody waits for it any more";
  return base::number_text(limit.seconds()) + " s of computing are over";
}

VirtualMachine::Status VirtualMachine::go(const Budget& budget, bool batch) {
  most_motions_ = budget.motions;
  input_waits_ = budget.input_waits;
  watch_clock(base::WorkLimit(budget.seconds, budget.unwanted));
  const bool fresh = status_ == Status::idle || status_ == Status::end;
  if (status_ == Status::alarm) return status_;
  if (status_ == Status::end) reset();
  if (fresh && !start_program()) return finish(Status::alarm);
  for (std::uint64_t steps = 0;;) {
    const std::uint64_t slice = budget.steps != 0 ? std::min(kSlice, budget.steps) : kSlice;
    slice_end_ = statistics_.motions() + kSlice;
    if (most_motions_ != 0 && !all_motions_made()) slice_end_ = std::min(slice_end_, most_motions_);
    const Halt halt = control().run(slice);
    steps += slice;
    if (progress_) progress_();
    if (halt == Halt::none && search_is_over(slice)) return finish(Status::alarm);
    if (halt == Halt::none && (servo_.broken_off() || refused_)) return finish(Status::budget);
    if (!input_waits_ && input_wait_.waits()) return waits_for_signal();
    if (motions_spent_) return spent("the motions allowed are made");
    // Whatever it has halted for: a program may do nothing but stop, and a batch run goes on.
    if (limit_.unwanted()) return spent(words_for(limit_));
    switch (halt) {
      case Halt::end: return finish(Status::end);
      case Halt::alarm:
        if (!passes_alarm()) return finish(Status::alarm);
        break;
      case Halt::optional_stop: return finish(Status::stopped);
      case Halt::single_block:
      case Halt::program_stop:
      case Halt::message:
      case Halt::gate:
        if (!batch) return finish(Status::running);
        break;
      case Halt::none: break;
    }
    if (budget.steps != 0 && steps >= budget.steps) return spent("the steps allowed are made");
    if (limit_.out_of_time()) return spent(words_for(limit_));
  }
}

VirtualMachine::Status VirtualMachine::cycle_start(const Budget& budget) {
  return go(budget, false);
}

VirtualMachine::Status VirtualMachine::run_to_end(const Budget& budget) { return go(budget, true); }

void VirtualMachine::reset() {
  dialect_->reset();
  spindle_beam_.reset();
  beam_ = {};
  alarm_.reset();
  drive_alarm_.reset();
  near_singular_.reset();
  refused_ = false;
  servo_.resume();
  notice_.reset();
  status_ = Status::idle;
}

}  // namespace kerf::machine
