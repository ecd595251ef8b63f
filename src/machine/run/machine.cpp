#include "machine/run/machine.hpp"

#include "machine/dialect/registry.hpp"

namespace kerf::machine {

Machine::Machine(const MachineDefinition& definition, control::Memory memory,
                 const Settings& settings)
    : definition_(definition),
      memory_(std::move(memory)),
      signals_(settings.signals),
      statistics_(definition_.axes),
      turning_statistics_(definition_.axes),
      spindle_beam_(definition_.drive.laser),
      dotted_cut_(definition_.drive.laser),
      dialect_name_(settings.plan              ? kDrawingDialect
                    : settings.dialect.empty() ? definition.dialect
                                               : settings.dialect),
      servo_(definition_,
             dialect_name_ == kPatternDialect && !settings.by_hand ? &records_ : nullptr),
      joints_(servo_.kinematics(), definition_.axes, definition_.start),
      dialect_(make_dialect(dialect_name_, {definition_, memory_, sources_, signals_, *this, *this,
                                            settings.pages, records_, settings.plan})) {
  for (const std::string& folder : settings.library_folders) dialect_->add_library_folder(folder);
  if (settings.on_one_thread) servo_.stay_on_one_thread();
  control().set_block_skip(settings.block_skip);
  control().set_optional_stop(settings.optional_stop);
}

Machine::~Machine() = default;

void Machine::load(std::unique_ptr<base::SourceFile> file) {
  dialect_->load(add_source(std::move(file)));
}

void Machine::check(base::Findings& found) {
  dialect_->check(found);
  if (!found.cut_short()) return;
  base::Diagnostic warning = base::make_error(base::Code::budget_spent, {}, found.limit().reason());
  warning.severity = base::Severity::warning;
  warning.place.file = dialect_->main_file();
  warning.program = program_name();
  found.conclude(std::move(warning));
}

std::vector<base::Diagnostic> Machine::check() {
  base::Findings found;
  check(found);
  return found.list();
}

void Machine::raise(const base::Diagnostic& alarm) {
  if (!drive_alarm_) drive_alarm_ = alarm;
  servo_.break_off();
}

std::optional<base::Diagnostic> Machine::named(std::optional<base::Diagnostic> alarm) const {
  if (alarm && alarm->program.empty()) alarm->program = program_name();
  return alarm;
}

std::uint32_t Machine::inputs(std::size_t word) {
  input_wait_.read(servo_.time_s());
  return signals_.inputs(word);
}

// The sensor for tools is no part of the work.
std::optional<double> Machine::contact(const motion::SkipMove& move) {
  const bool is_said = contacts_.any() || move.feeler == motion::Feeler::tool_setter;
  if (is_said || skip_signal_ == nullptr) return contacts_.comes_on(move);
  return skip_signal_->comes_on(move);
}

void Machine::print(std::string_view text) {
  if (print_output_) print_output_(text);
}

// Where the axes were moved by hand the program finds its beam as it left it.
void Machine::take(const motion::Motion& motion) {
  for (const motion::Motion& each : spindle_beam_.translated(motion)) {
    if (const auto* const power = std::get_if<motion::Power>(&each.action)) beam_ = *power;
    if (motion::target_of(each) != nullptr) switch_beam(beam_, each);
    if (const auto z = z_first(each)) make(*z);
    make(each);
  }
}

// The part of a rapid that only brings Z to its place, where the machine has it so (tip.z_first)
// and the other axes move as well.
std::optional<motion::Motion> Machine::z_first(const motion::Motion& motion) const {
  const auto* const rapid = std::get_if<motion::Rapid>(&motion.action);
  const auto z = definition_.axes.find('Z');
  if (!definition_.tip.z_first || rapid == nullptr || !z) return std::nullopt;
  motion::Rapid first = *rapid;
  first.to = servo_.commanded();
  first.to[*z] = rapid->to[*z];
  if (first.to == servo_.commanded() || first.to == rapid->to) return std::nullopt;
  motion::Motion part = motion;
  part.action = first;
  part.exact_stop = false;
  return part;
}

void Machine::switch_beam(const motion::Power& power, const motion::Motion& move) {
  if (power == made_beam_) return;
  motion::Motion motion = move;
  motion.action = power;
  make(motion);
}

void Machine::switch_beam_off(const motion::Motion& move) {
  if (made_beam_.beam_percent() > 0) switch_beam({}, move);
}

void Machine::make(const motion::Motion& motion) {
  if (!admits(motion)) return;
  if (motion::target_of(motion) != nullptr) input_wait_.moved();
  if (const auto* const power = std::get_if<motion::Power>(&motion.action)) made_beam_ = *power;
  statistics_.take(motion);
  turning_statistics_.take(motion);
  dotted_cut_.take(motion);
  servo_.take(alter_ ? alter_(motion) : motion);
  for (motion::MotionSink* const sink : sinks_) sink->take(motion);
  ++made_;
}

std::vector<base::Diagnostic> Machine::warnings() const {
  std::vector<base::Diagnostic> list;
  for (const auto& warning : {spindle_beam_.warning(), spindle_beam_.dwell_warning(),
                              dotted_cut_.warning(), joints_.caution()}) {
    if (warning) list.push_back(*warning);
  }
  return list;
}

void Machine::reset_control() {
  dialect_->reset();
  spindle_beam_.reset();
  beam_ = {};
  alarm_.reset();
  drive_alarm_.reset();
  joints_.forget_caution();
  servo_.resume();
  status_ = RunStatus::idle;
}

}  // namespace kerf::machine
