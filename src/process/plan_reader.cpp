#include "process/plan_reader.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "geometry/contour/edge.hpp"
#include "process/along.hpp"

namespace kerf::process {
namespace {

using motion::Motion;

constexpr double kHere_mm = 1e-9;
constexpr double kSpeck_mm = 1e-6;  // no control makes an arc of it

bool has_height(const PlannedOperation& planned) {
  return planned.operation.z || planned.operation.z_step != 0;
}

/// Any operation that names a height, or changes it from pass to pass.
bool names_z(const Plan& plan) {
  return plan.machine.focus_mm != 0 ||
         std::any_of(plan.operations.begin(), plan.operations.end(), has_height);
}

}  // namespace

PlanReader::PlanReader(const Plan& plan, const drawing::Drawing& drawing)
    : plan_(plan), drawing_(drawing), at_(plan.machine.axes.start), moves_z_(names_z(plan)) {
  if (plan.wrap.shape != Wrap::Shape::none && !plan.operations.empty())
    wrapping_.emplace(plan.wrap, plan.machine.axes, plan.tolerance_mm);
  find_operation();
}

std::uint32_t PlanReader::rounds() const {
  const Operation& operation = this->operation().operation;
  if (plan_.machine.has_beam || !operation.depth || !operation.step_down)
    return std::max(1U, operation.passes);
  return static_cast<std::uint32_t>(
      std::max(1.0, std::ceil(*operation.depth / *operation.step_down - 1e-9)));
}

double PlanReader::z_of_round() const {
  const Operation& operation = this->operation().operation;
  if (plan_.machine.has_beam)
    return operation.z.value_or(plan_.machine.focus_mm) + cursor_.round * operation.z_step;
  const double depth = operation.depth.value_or(0);
  if (!operation.step_down) return -depth;
  return -std::min(depth, (cursor_.round + 1) * *operation.step_down);
}

/// 5 mm above, where the machine has so much room.
double PlanReader::safe_z() const {
  constexpr double kUsual_mm = 5;
  if (operation().operation.safe_z) return *operation().operation.safe_z;
  const auto axis = plan_.machine.axes.find('Z');
  if (!axis) return kUsual_mm;
  const motion::AxisConfig& z = plan_.machine.axes[*axis];
  return z.travel_min < z.travel_max ? std::min(kUsual_mm, z.travel_max) : kUsual_mm;
}

bool PlanReader::next(std::vector<Step>& steps) {
  steps_ = &steps;
  if (has_ended_) return false;
  const bool is_over = cursor_.copy >= plan_.copies.size() || plan_.operations.empty();
  if (is_over) {
    finish();
    return true;
  }
  if (!began_operation_) begin_operation();
  if (cursor_.turn < operation().turns.size()) {
    const Turn turn = operation().turns[cursor_.turn];
    make(operation().passes[turn.item], turn.entry);
  } else {
    cursor_.turn = operation().turns.size();
    advance_turn();
  }
  return true;
}

void PlanReader::make(const Pass& pass, std::size_t entry) {
  const drawing::Entity& entity = drawing_.entities[pass.entity];
  block_ = {};
  block_.file = entity.file;
  block_.line = entity.line;
  block_.column = 1;
  const bool is_first = cursor_.line == 0;
  if (is_first)
    steps_->emplace_back(PassBegins{cursor_.operation, cursor_.copy, pass.contour, pass.entity});
  if (const auto* scan = std::get_if<Scan>(&pass.what)) {
    make_scan_line(scan->run_up, scan->lines[cursor_.line]);
    if (++cursor_.line < scan->lines.size()) return;
    cursor_.line = 0;
  } else if (const auto* picture = std::get_if<Picture>(&pass.what)) {
    ++cursor_.line;
    if (make_row(*picture)) return;
    cursor_.line = 0;
  } else if (const auto* spot = std::get_if<Spot>(&pass.what)) {
    make_spot(*spot);
  } else {
    make_way(way_of(std::get<Along>(pass.what), entry, operation().rules));
  }
  advance();
}

/// From pass to pass of a contour, or to the next one.
void PlanReader::advance() {
  const bool repeats_contour = operation().operation.pass_order == PassOrder::contour;
  if (repeats_contour && cursor_.round + 1 < rounds()) {
    ++cursor_.round;
    return;
  }
  if (repeats_contour) cursor_.round = 0;
  ++cursor_.turn;
  advance_turn();
}

/// To the next round, operation or copy, where the turns are over.
void PlanReader::advance_turn() {
  if (cursor_.turn < operation().turns.size()) return;
  cursor_.turn = 0;
  const bool repeats_operation = operation().operation.pass_order == PassOrder::operation;
  if (repeats_operation && !operation().turns.empty() && cursor_.round + 1 < rounds()) {
    ++cursor_.round;
    return;
  }
  cursor_.round = 0;
  began_operation_ = false;
  ++cursor_.operation;
  find_operation();
}

/// The next one of this copy, or the first one of the next copy that has any.
void PlanReader::find_operation() {
  const auto is_of_copy = [&](const PlannedOperation& planned) {
    return planned.copy == drawing::kEveryCopy || planned.copy == cursor_.copy;
  };
  for (; cursor_.copy < plan_.copies.size(); ++cursor_.copy, cursor_.operation = 0) {
    while (cursor_.operation < plan_.operations.size() &&
           !is_of_copy(plan_.operations[cursor_.operation]))
      ++cursor_.operation;
    if (cursor_.operation < plan_.operations.size()) return;
  }
}

void PlanReader::begin_operation() {
  began_operation_ = true;
  const Operation& operation = this->operation().operation;
  if (operation.air != air_) {
    air_ = operation.air;
    using State = motion::Coolant::State;
    emit(motion::Coolant{air_ == Air::off    ? State::off
                         : air_ == Air::mist ? State::mist
                                             : State::flood});
  }
  if (plan_.machine.has_beam) return;
  if (operation.tool) emit(motion::ToolChange{*operation.tool});
  if (operation.spindle) {
    motion::Spindle spindle;
    spindle.turning = motion::Spindle::Turning::clockwise;
    spindle.speed = *operation.spindle;
    emit(spindle);
  }
}

base::TipPoint PlanReader::point(Vec2 at) const {
  base::TipPoint to = at_;
  const motion::AxisSetup& axes = plan_.machine.axes;
  if (const auto x = axes.find('X')) to[*x] = base::tidy(at.u);
  if (const auto y = axes.find('Y')) to[*y] = base::tidy(at.v);
  return to;
}

void PlanReader::emit(const Motion::Action& action) {
  Motion motion;
  motion.block = block_;
  motion.action = action;
  steps_->emplace_back(motion);
  if (const base::TipPoint* to = motion::target_of(motion)) at_ = *to;
}

void PlanReader::beam(double share) {
  if (!plan_.machine.has_beam || plan_.machine.makes_patterns) return;
  motion::Power power;
  power.percent = base::tidy(share * operation().settled.power_percent);
  power.follows_speed = share > 0 && operation().settled.beam == Beam::follow;
  power.frequency_hz = share > 0 ? operation().settled.frequency_hz : 0;
  if (power_ == power) return;
  power_ = power;
  emit(power);
}

void PlanReader::rapid_z(double z) {
  const auto axis = plan_.machine.axes.find('Z');
  if (!axis || std::abs(at_[*axis] - z) <= kHere_mm) return;
  base::TipPoint to = at_;
  to[*axis] = z;
  emit(motion::Rapid{to, true});
}

/// Over a surface; the first time from wherever the head stands, to above the place first.
void PlanReader::travel_to(Vec2 to) {
  beam(0);
  const Vec2 from = is_on_surface_ ? flat_ : to;
  for (const base::TipPoint& point : wrapping_->travel(from, to, at_))
    if (!(point == at_)) emit(motion::Rapid{point, true});
  flat_ = to;
  is_on_surface_ = true;
}

void PlanReader::cut_wrapped(Vec2 to, double bulge) {
  const motion::Feed feed{operation().settled.feed, motion::FeedMode::per_minute};
  if (to == flat_) return;
  for (const WrappedTarget& target : wrapping_->cut({flat_, to, bulge}, at_)) {
    if (target.to == at_) continue;
    if (target.via)
      emit(motion::SpaceArc{target.to, *target.via, {}, feed, false});
    else
      emit(motion::Line{target.to, feed});
  }
  flat_ = to;
}

void PlanReader::rapid_to(Vec2 to) {
  if (wrapping_) {
    if (!is_on_surface_ || to != flat_) travel_to(to);
    return;
  }
  const base::TipPoint target = point(to);
  if (target == at_) return;
  beam(0);
  emit(motion::Rapid{target, true});
}

void PlanReader::line_to(Vec2 to) {
  if (wrapping_) return cut_wrapped(to, 0);
  const base::TipPoint target = point(to);
  if (target == at_) return;
  emit(motion::Line{target, {operation().settled.feed, motion::FeedMode::per_minute}});
}

void PlanReader::leg_to(const Leg& leg) {
  const drawing::Affine& copy = plan_.copies[cursor_.copy];
  const motion::AxisSetup& axes = plan_.machine.axes;
  const auto x = axes.find('X');
  const auto y = axes.find('Y');
  beam(leg.power);
  const Vec2 to = copy(leg.to);
  if (wrapping_) return cut_wrapped(to, leg.bulge);
  const bool is_speck = x && y && std::abs(leg.bulge) <= 1 &&
                        geometry::length(to - Vec2{at_[*x], at_[*y]}) < kSpeck_mm;
  if (is_speck) return;  // the next leg begins here
  if (leg.bulge == 0 || !x || !y) return line_to(to);
  const contour::Edge arc{{at_[*x], at_[*y]}, to, leg.bulge};
  const Vec2 middle = centre(arc);
  motion::Arc action;
  action.to = point(to);
  action.center = {base::tidy(middle.u), base::tidy(middle.v)};
  action.feed = {operation().settled.feed, motion::FeedMode::per_minute};
  action.direction =
      leg.bulge > 0 ? motion::Direction::counterclockwise : motion::Direction::clockwise;
  emit(action);
}

void PlanReader::dwell(double seconds) {
  if (seconds > 0) emit(motion::Dwell{seconds});
}

void PlanReader::make_way(const Way& way) {
  const drawing::Affine& copy = plan_.copies[cursor_.copy];
  const Vec2 begin = copy(way.begin);
  const bool is_mill = !plan_.machine.has_beam;
  const auto z_axis = plan_.machine.axes.find('Z');
  const double z = z_of_round();
  if (is_mill) {
    rapid_z(safe_z());
    rapid_to(begin);
    if (z_axis) {
      base::TipPoint to = at_;
      to[*z_axis] = z;
      emit(motion::Line{to,
                        {operation().operation.plunge.value_or(0.3 * operation().settled.feed),
                         motion::FeedMode::per_minute}});
    }
  } else {
    const bool rises = z_axis && z > at_[*z_axis];
    const bool z_comes_first = rises || plan_.machine.z_first;
    if (moves_z_ && z_comes_first) beam(0), rapid_z(z);
    rapid_to(begin);
    if (moves_z_) beam(0), rapid_z(z);
    if (way.pierce_s > 0) {
      beam(operation().operation.pierce_power_percent.value_or(operation().settled.power_percent) /
           std::max(operation().settled.power_percent, 1e-9));
      dwell(way.pierce_s);
    }
  }
  for (const Leg& leg : way.legs) leg_to(leg);
  beam(0);
  if (is_mill) rapid_z(safe_z());
}

void PlanReader::make_spot(const Spot& spot) {
  rapid_to(plan_.copies[cursor_.copy](spot.at));
  burn(operation().settled.burn_s);
}

void PlanReader::burn(double seconds) {
  beam(1);
  dwell(seconds);
  beam(0);
}

/// False: there was none any more.
bool PlanReader::make_row(const Picture& picture) {
  if (!raster_) {
    auto made = Raster::make(*picture.image, picture.operation, picture.settled, picture.size_mm);
    if (!made) return false;  // told when it was planned
    raster_.emplace(std::move(*made));
  }
  if (!raster_->next(row_)) {
    raster_.reset();
    return false;
  }
  row_.origin = picture.placed(row_.origin);
  row_.along = picture.placed.direction(row_.along);
  make_scan_line(picture.run_up, row_);
  return true;
}

/// Beam off and feed kept in gaps that are shorter than run-out and run-up together.
void PlanReader::make_scan_line(double run_up, const ScanLine& line) {
  const drawing::Affine& copy = plan_.copies[cursor_.copy];
  const auto at = [&](double along) { return copy(line.origin + along * line.along); };
  if (moves_z_) beam(0), rapid_z(z_of_round());
  double last = 0;
  bool has_begun = false;
  for (const Run& run : line.runs) {
    const bool goes_on = has_begun && run.from - last < 2 * run_up;
    if (has_begun && !goes_on) {
      beam(0);
      line_to(at(last + run_up));
    }
    if (!goes_on) rapid_to(at(run.from - run_up));
    if (!has_begun || run.from > last) beam(0);
    line_to(at(run.from));
    leg_to({line.origin + run.to * line.along, 0, run.power});
    last = run.to;
    has_begun = true;
  }
  beam(0);
  line_to(at(last + run_up));
}

void PlanReader::finish() {
  has_ended_ = true;
  if (air_ != Air::off) emit(motion::Coolant{motion::Coolant::State::off});
  if (!plan_.machine.has_beam) {
    motion::Spindle stop;
    emit(stop);
  }
  cursor_ = {};
  if (wrapping_ && is_on_surface_) {
    beam(0);
    emit(motion::Rapid{wrapping_->tip(flat_, plan_.wrap.clearance, at_), true});
  } else if (!plan_.operations.empty() && plan_.end.kind != EndKind::stay)
    rapid_to(plan_.end.kind == EndKind::point ? plan_.end.at : plan_.origin);
  emit(motion::End{});
}

}  // namespace kerf::process
