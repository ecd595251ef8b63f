#include "machine/panel/internal/live_run.hpp"

#include <algorithm>
#include <utility>

#include "machine/dialect/refused.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::machine {
namespace {

// What a dial at 0 is until the first point of a motion that it holds.
constexpr double kCreep = 1e-4;

}  // namespace

LiveRun::LiveRun(const MachineDefinition& definition, control::Memory memory,
                 const Machine::Settings& settings, Stepper& stepper, MovedBy moved_by,
                 std::uint64_t number)
    : machine_(definition, std::move(memory), settings),
      trail_(machine_.language(), std::as_const(machine_).memory(), definition.axes.start),
      read_ahead_(machine_.control(), stepper),
      moved_by_(moved_by),
      number_(number) {
  machine_.add_sink(trail_);
  machine_.add_sink(read_ahead_);
  machine_.add_point_sink(*this);
  machine_.observe_rest([this] { trail_.settle(); });
}

void LiveRun::take(const motion::AxisPoint& point) {
  latest_.take(last());
  const motion::MoveKind kind = point.tip.mark.kind;
  const bool at_zero = (kind == motion::MoveKind::cut && dials_.feed == 0) ||
                       (kind == motion::MoveKind::rapid && dials_.rapid == 0);
  if (!at_zero || source().wants_hold()) return;
  dial_hold_ = true;
  source().hold();
}

bool LiveRun::is_pattern() const { return machine_.dialect() == kPatternDialect; }

bool LiveRun::is_behind_pattern() const {
  return is_pattern() && moved_by_ == MovedBy::program && !is_active() && !machine_.is_in_program();
}

// What is under way

void LiveRun::begin(Activity activity) {
  activity_ = activity;
  deadline_s = time_s();
}

void LiveRun::begin_next(Activity activity) {
  begin(activity);
  ++number_;
}

base::Outcome<void> LiveRun::move_by_hand(const std::vector<motion::Motion>& motions) {
  trail_.settle();
  bool any = false;
  for (const motion::Motion& motion : motions) {
    if (const auto refusal = machine_.command(motion)) {
      if (!any) {
        activity_ = Activity::none;
        return refused(base::refuse_for(std::string(base::text_of(refusal->code).number),
                                        base::Refusal::joints_cannot, {refusal->sentence}));
      }
      hand_end = HandEnd{refusal->code, refusal->sentence};
      break;
    }
    any = true;
  }
  deadline_s = time_s();
  machine_.finish_moves();
  return {};
}

bool LiveRun::ended_early(Console& console) {
  const auto end = std::exchange(hand_end, {});
  if (end) console.raise(end->code, end->sentence);
  return end.has_value();
}

void LiveRun::finish_reset() {
  machine_.drop_ahead();
  machine_.reset();
  machine_.abandon();
  activity_ = Activity::none;
  feed_hold_ = block_hold_ = dial_hold_ = false;
  is_resetting = is_jog_stopping = is_entry = false;
  hand_end.reset();
}

void LiveRun::tell_messages(Console& console) {
  const std::vector<std::string>& texts = machine_.statistics().messages();
  for (; said_ < texts.size(); ++said_) console.say(texts[said_]);
}

void LiveRun::tell_missed_interrupts(Console& console) {
  const std::uint64_t missed = machine_.control().interrupts_missed();
  if (std::exchange(interrupts_missed_, missed) < missed)
    console.say("an interrupt signal came while no M96 was in force: it did nothing");
}

// What holds it

void LiveRun::hold_feed() {
  feed_hold_ = true;
  block_hold_ = false;
  source().hold();
}

void LiveRun::hold_behind_block() {
  source().hold_behind_block();
  block_hold_ = true;
}

void LiveRun::resume_feed() {
  release_holds();
  if (!dial_hold_) source().resume();
}

bool LiveRun::outruns_block_hold() {
  const bool outruns =
      is_active() && block_hold_ && source().held() && source().empty() && machine_.has_halted();
  if (!outruns) return false;
  block_hold_ = false;
  source().resume();
  return true;
}

void LiveRun::set_dials(const OverrideDials& dials) {
  const auto share = [](int percent) { return std::max(percent / 100.0, kCreep); };
  dials_ = dials;
  source().set_overrides({share(dials.feed), share(dials.rapid)});
  source().set_spindle_override(dials.spindle / 100.0);
  machine_.servo().set_power_override(dials.spindle / 100.0);
  release_dial();
}

void LiveRun::release_dial() {
  if (!dial_hold_) return;
  const bool is_rapid = last().mark.kind == motion::MoveKind::rapid;
  if ((is_rapid ? dials_.rapid : dials_.feed) == 0) return;
  dial_hold_ = false;
  if (!feed_hold_ && !is_resetting && !block_hold_) source().resume();
}

// What was read, and the axes

bool LiveRun::is_ahead() const {
  return is_active() && is(Activity::program) && !machine_.servo().at_rest();
}

bool LiveRun::stands() const {
  if (!is_active()) return true;
  const Servo& servo = machine_.servo();
  return servo.held() || servo.standing() || servo.at_rest();
}

const BlockState* LiveRun::block_made() {
  const motion::Mark& mark = last().mark;
  return is_active() && mark.motion != 0 ? &trail_.at(mark.motion) : nullptr;
}

const BlockState* LiveRun::image_made() {
  if (!is_active() || machine_.servo().at_rest()) return nullptr;
  return &trail_.at(last().mark.motion);
}

std::size_t LiveRun::shown_levels() {
  const BlockState* const made = block_made();
  return made ? made->calls.size() : machine_.control().open_calls().size();
}

// Its memory

void LiveRun::put_back(const BlockState& made, control::Memory& memory) const {
  machine_.language().variables().put_back(made.variables->values(), memory);
  made.tables->put_back(memory);
}

control::Memory LiveRun::memory() {
  control::Memory memory = machine_.memory();
  if (const BlockState* const made = image_made()) put_back(*made, memory);
  return memory;
}

void LiveRun::set_memory(control::Memory memory) {
  memory.revision = machine_.memory().revision + 1;
  machine_.memory() = std::move(memory);
  machine_.language().offsets_changed();
}

void LiveRun::forget_ahead() {
  put_back(trail_.at(last().mark.motion), machine_.memory());
  machine_.language().offsets_changed();
}

VariableListing LiveRun::at_block_made(const std::function<VariableListing()>& list) {
  if (image_made() == nullptr) return list();
  control::Memory ahead = std::exchange(machine_.memory(), memory());
  VariableListing listing = list();
  machine_.memory() = std::move(ahead);
  return listing;
}

}  // namespace kerf::machine
