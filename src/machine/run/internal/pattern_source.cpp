#include "machine/run/internal/pattern_source.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/decimal.hpp"
#include "drive/pattern/split.hpp"
#include "motion/feed.hpp"

namespace kerf::machine {
namespace {

constexpr double kNanoseconds = 1e9;

std::array<double, drive::kArmAxes> as_numbers(const drive::ArmCounts& counts) {
  std::array<double, drive::kArmAxes> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<double>(counts.values[i]);
  return numbers;
}

motion::Mark mark_of(const motion::Motion& motion, std::uint64_t number) {
  motion::Mark mark;
  mark.block = motion.block;
  mark.motion = number;
  const auto* const line = std::get_if<motion::Line>(&motion.action);
  mark.kind = line != nullptr ? motion::MoveKind::cut : motion::MoveKind::rapid;
  if (line != nullptr)
    mark.speed = static_cast<float>(line->feed.value / motion::kSecondsPerMinute);
  return mark;
}

}  // namespace

PatternSource::PatternSource(const PatternMachine& machine, PatternQueue& records)
    : machine_(machine),
      records_(records),
      period_s_(machine.definition().interpolator.period_s),
      motors_(machine, lines_),
      before_(motors_),
      at_(stand_after(machine, {})) {}

double PatternSource::time_of(std::uint64_t tick) const {
  return base::tidy(static_cast<double>(tick) * period_s_);
}

void PatternSource::take(const motion::Motion& motion) {
  ++motions_;
  is_finished_ = false;
  if (motion::target_of(motion) == nullptr) return;
  assert(!records_.empty());
  items_.push_back({records_.front(), mark_of(motion, motions_)});
  records_.pop_front();
}

void PatternSource::make(const drive::PatternRecord& record) {
  lines_.begin(motors_.time_ns(), motors_.counters());
  [[maybe_unused]] const auto made = motors_.make(record);
  assert(made);  // the control has made it before
  lines_.end();
  end_s_ = motors_.time_s() + motors_late_s_;
}

// Behind a rest the motors go on at the point at which they stand.
void PatternSource::begin_record() {
  if (items_.front().queued.from.values != motors_.counters().values) approach(items_.front());
  under_way_ = items_.front();
  items_.pop_front();
  if (is_resting_) motors_late_s_ = time_of(tick_) - motors_.time_s();
  is_resting_ = false;
  is_under_way_ = true;
  is_cut_short_ = false;
  before_ = motors_;
  make(under_way_.queued.record);
}

void PatternSource::end_record() {
  if (!is_under_way_) return;
  is_under_way_ = false;
  is_block_over_ = is_block_over_ || under_way_.queued.ends_block;
}

void PatternSource::approach(const Item& next) {
  const drive::ArmCounts& now = motors_.counters();
  const drive::ArmCounts& to = next.queued.from;
  using enum drive::ArmAxis;
  const auto& lift = machine_.definition().driven[index(drive::axis_of(z))];
  const double high = machine_.joints_at(now)[drive::axis_of(z)];
  const double low = machine_.joints_at(to)[drive::axis_of(z)];
  const double clear = std::min(machine_.definition().pattern.travel_z_mm, lift.travel_high);
  const bool arms_move =
      now[theta1] != to[theta1] || now[theta2] != to[theta2] || now[theta3] != to[theta3];
  const double above = arms_move ? std::max({high, low, clear}) : low;
  const std::int64_t top = base::round_away(above * lift.steps_per_unit);
  const std::array moves = {
      drive::FastMove{z, top - now[z]}, drive::FastMove{theta2, to[theta2] - now[theta2]},
      drive::FastMove{theta1, to[theta1] - now[theta1]},
      drive::FastMove{theta3, to[theta3] - now[theta3]}, drive::FastMove{z, to[z] - top}};
  std::deque<Item> way;
  Item item = next;
  item.mark.kind = motion::MoveKind::rapid;
  item.mark.speed = 0;
  item.queued.ends_block = false;
  item.queued.from = now;
  for (const drive::FastMove& move : moves) {
    drive::each_record(move, [&](const drive::FastRecord& record) {
      item.queued.record = record;
      way.push_back(item);
      item.queued.from[record.axis] += record.field.count();
    });
  }
  items_.insert(items_.begin(), way.begin(), way.end());
}

// A fast record under way ends as soon as its motor can rest; the rest of it is a record behind it.
void PatternSource::cut_short() {
  const auto* const whole = std::get_if<drive::FastRecord>(&under_way_.queued.record);
  if (whole == nullptr || is_cut_short_) return;
  is_cut_short_ = true;
  const std::size_t motor = index(drive::axis_of(whole->axis));
  const double begun = static_cast<double>(before_.counters().values[motor]);
  const double way = std::fabs(counts_at(time_of(tick_))[motor] - begun);
  // Up to the first pulse behind the last point.
  const std::int64_t fewest =
      drive::FastProfile(machine_.definition().drive.arm.fast, whole->field.pulses)
          .fewest_pulses(way + 1);
  if (fewest >= whole->field.pulses) return;
  drive::FastRecord part = *whole;
  Item left = under_way_;
  part.field.pulses = static_cast<std::uint16_t>(fewest);
  std::get<drive::FastRecord>(left.queued.record).field.pulses -= part.field.pulses;
  under_way_.queued.record = part;
  under_way_.queued.ends_block = false;
  motors_ = before_;
  make(part);
  left.queued.from = motors_.counters();
  items_.push_front(left);
}

std::array<double, drive::kArmAxes> PatternSource::counts_at(double time_s) {
  return lines_.at((time_s - motors_late_s_) * kNanoseconds);
}

void PatternSource::tell(motion::Setpoint& point,
                         const std::array<double, drive::kArmAxes>& counts) {
  ++tick_;
  at_ = stand_after(machine_, counts);
  point = {time_s(), at_.tip, under_way_.mark};
}

bool PatternSource::next(motion::Setpoint& point) {
  is_held_ = false;
  if (is_under_way_ && (hold_ == Hold::at_once || hold_ == Hold::reset)) cut_short();
  const double time_s = time_of(tick_ + 1);
  while (!is_under_way_ || end_s_ < time_s) {
    end_record();
    if (holds_here()) return stand(point);
    if (items_.empty()) return rest(point);
    begin_record();
  }
  tell(point, counts_at(time_s));
  return true;
}

// Behind the last record: the point at which all stands, as far as there is none yet.
bool PatternSource::rest(motion::Setpoint& point) {
  if (!is_finished_ || is_resting_) return false;
  is_resting_ = true;
  if (time_of(tick_) >= end_s_) return false;
  tell(point, as_numbers(motors_.counters()));
  return true;
}

bool PatternSource::stand(motion::Setpoint& point) {
  is_held_ = is_resting_ = true;
  if (hold_ == Hold::reset) drop();
  tell(point, as_numbers(motors_.counters()));
  return true;
}

void PatternSource::skip() {
  motion::Setpoint point;
  while (next(point)) {
  }
}

bool PatternSource::holds_here() const {
  return hold_ == Hold::behind_block ? is_block_over_ : hold_ != Hold::none;
}

void PatternSource::hold_behind_block() {
  if (hold_ != Hold::none) return;
  hold_ = Hold::behind_block;
  is_block_over_ = false;
}

void PatternSource::resume() {
  hold_ = Hold::none;
  is_held_ = false;
}

void PatternSource::reset() {
  hold_ = Hold::reset;
  if (is_held_) drop();
}

// Everything ahead is forgotten.
void PatternSource::drop() {
  items_.clear();
  records_.clear();
}

}  // namespace kerf::machine
