#include "planner/look_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::planner {
namespace {

// An item of more cells would leave no room for others.
constexpr std::uint64_t kMostCells = 256;
// Speeds that differ by less, relatively, are the same: rounding of a plan made anew.
constexpr double kSameSpeed = 1e-12;
// Of two cells as one the better limits are lost: no more than this share of them.
constexpr double kAlike = 0.5;

bool alike(double a, double b) { return std::min(a, b) >= kAlike * std::max(a, b); }

}  // namespace

void LookAhead::Run::add(const Section& section) {
  length += section.length;
  limits.velocity = std::min(limits.velocity, section.limits.velocity);
  limits.acceleration = std::min(limits.acceleration, section.limits.acceleration);
  limits.jerk = std::min(limits.jerk, section.limits.jerk);
}

double LookAhead::Run::speed_from(double speed) const {
  return reachable_speed(speed, length, limits, limits.velocity);
}

// The last item is one with the one before it, which is not planned yet.
bool LookAhead::goes_on_at_the_end() const {
  if (!jerk_limited_ || items_.end() - 1 == std::max(planned_, items_.begin())) return false;
  const Section& last = items_[items_.end() - 2].section;
  const Section& next = items_[items_.end() - 1].section;
  return last.cells < kMostCells && !last.stop && next.dwell_s == 0 &&
         next.limits.velocity == last.limits.velocity &&
         alike(next.limits.acceleration, last.limits.acceleration) &&
         alike(next.limits.jerk, last.limits.jerk);
}

void LookAhead::join_at_the_end() {
  Section& last = items_[items_.end() - 2].section;
  const Section& next = items_.back().section;
  Run both{last.length, last.limits};
  both.add(next);
  last.length = both.length;
  last.limits = both.limits;
  last.stop = next.stop;
  last.cells += next.cells;
  last.tail = next.tail;
  items_.unpush();
}

void LookAhead::absorb(const Ring<Cell>& cells) {
  for (; seen_ < cells.end() && items_.room() > 0 && stop_way_ > 0; ++seen_) {
    const Cell& cell = cells[seen_];
    const double length = cell.length() - offset_;
    const bool stops_inside = length >= stop_way_;
    Item& item = items_.push();
    item.items = 1;
    if (stops_inside) {
      offset_ += stop_way_;
      item.section = {stop_way_, cell.limits, 0, 0, 0, offset_, 0, true};
      stop_way_ = 0;
    } else {
      item.section = {length, cell.limits, 0, 0, 1, 0, cell.dwell_s, cell.stop};
      stop_way_ -= length;
      offset_ = 0;
    }
    if (goes_on_at_the_end()) join_at_the_end();
    if (stops_inside) return;
  }
}

void LookAhead::begin_at(std::uint64_t cell, double offset, double speed) {
  items_.clear();
  planned_ = items_.begin();
  seen_ = cell;
  offset_ = offset;
  stop_way_ = kNever;
  entry_ = speed;
}

bool LookAhead::plan(bool ended) {
  const std::uint64_t begin = std::max(planned_, items_.begin());
  const std::uint64_t end = items_.end();
  if (begin == end) return true;
  if (jerk_limited_) {
    look_back(begin, end);
    if (items_[begin].bound < entry_ * (1 - kSameSpeed)) return false;
    go_forward(begin, end);
  } else if (!plan_accelerations(begin, end)) {
    return false;
  }
  release(ended || items_.back().section.stop);
  return true;
}

bool LookAhead::plan_accelerations(std::uint64_t begin, std::uint64_t end) {
  double speed = 0;
  for (std::uint64_t n = end; n-- > begin;) {
    Section& section = items_[n].section;
    section.exit = section.stop ? 0 : std::min(speed, section.limits.velocity);
    speed = reachable_speed(section.exit, section.length, section.limits, section.limits.velocity);
  }
  if (speed < entry_ * (1 - kSameSpeed)) return false;
  speed = entry_;
  for (std::uint64_t n = begin; n < end; ++n) {
    Section& section = items_[n].section;
    section.entry = speed;
    section.exit = reachable_speed(speed, section.length, section.limits, section.exit);
    speed = section.exit;
  }
  return true;
}

// Highest speed where item `number` begins, the end of the one before.
double LookAhead::speed_allowed_at(std::uint64_t number, std::uint64_t end) const {
  const Section& before = items_[number - 1].section;
  if (number == end || before.stop) return 0;
  return std::min(items_[number].bound, before.limits.velocity);
}

void LookAhead::look_back(std::uint64_t begin, std::uint64_t end) {
  Run run;
  std::uint64_t until = end;
  double exit = 0;
  for (std::uint64_t n = end; n-- > begin;) {
    Item& item = items_[n];
    const double next = speed_allowed_at(n + 1, end);
    Run alone;
    alone.add(item.section);
    const double fresh = alone.speed_from(next);
    run.add(item.section);
    const double longer = item.section.stop ? -1 : run.speed_from(exit);
    if (longer <= fresh) {
      run = alone;
      until = n + 1;
      exit = next;
    }
    item.bound = std::max(longer, fresh);
    item.until = until;
  }
}

// How long one profile from `begin` to `end` takes; kNever when it cannot be: an item is slower
// than `least`, or the change of speed does not fit.
double LookAhead::time_s(std::uint64_t begin, std::uint64_t end, double entry, double exit,
                         double least) const {
  Run run;
  for (std::uint64_t n = begin; n < end; ++n) run.add(items_[n].section);
  if (run.limits.velocity < std::max({least, entry, exit})) return kNever;
  if (ramp_length(entry, exit, run.limits) > run.length) return kNever;
  return Profile(run.length, entry, exit, run.limits).duration_s();
}

void LookAhead::set_section(std::uint64_t begin, std::uint64_t end, double entry, double exit) {
  Item& first = items_[begin];
  first.items = static_cast<std::uint32_t>(end - begin);
  first.section.entry = entry;
  first.section.exit = exit;
}

// Three ways to go on where the way down that look_back() found must begin in or behind item `n`:
// one section from `from` to its end; a section up to the end of the item, and then the way down;
// or the way down from the begin of the item, which is always possible.
LookAhead::Way LookAhead::way_down(const Way& up, std::uint64_t n, double speed, double reached,
                                   std::uint64_t end) {
  const std::uint64_t behind = n + 1;
  const double allowed = speed_allowed_at(behind, end);
  const bool ends_here = behind == end || items_[n].section.stop;
  const std::uint64_t until = ends_here ? behind : items_[behind].until;
  const double exit = ends_here ? 0 : speed_allowed_at(until, end);
  const double joined_s = time_s(up.from, until, up.entry, exit, reached);
  const double first_s = time_s(up.from, behind, up.entry, allowed, allowed);
  const double down_s = until == behind ? 0 : time_s(behind, until, allowed, exit, allowed);
  if (joined_s < kNever && joined_s <= first_s + down_s) {
    set_section(up.from, until, up.entry, exit);
    return {until, exit};
  }
  if (first_s < kNever) {
    set_section(up.from, behind, up.entry, allowed);
    return {behind, allowed};
  }
  if (n > up.from) set_section(up.from, n, up.entry, speed);
  Run run;
  for (std::uint64_t i = n; i < items_[n].until; ++i) run.add(items_[i].section);
  const double entry = n > up.from ? speed : up.entry;
  const double last = std::min(speed_allowed_at(items_[n].until, end), run.speed_from(entry));
  set_section(n, items_[n].until, entry, last);
  return {items_[n].until, last};
}

void LookAhead::go_forward(std::uint64_t begin, std::uint64_t end) {
  Way up{begin, entry_};  // the section under way
  double speed = entry_;  // where item n begins
  Run run;
  for (std::uint64_t n = begin; n < end;) {
    Run alone;
    alone.add(items_[n].section);
    const double fresh = alone.speed_from(speed);
    run.add(items_[n].section);
    const double longer = run.limits.velocity >= up.entry ? run.speed_from(up.entry) : -1;
    if (longer <= fresh && n > up.from) {
      set_section(up.from, n, up.entry, speed);
      up = {n, speed};
      run = alone;
    }
    const double reached = std::max(longer, fresh);
    const bool at_end = n + 1 == end || items_[n].section.stop;
    if (!at_end && reached < items_[n + 1].bound) {
      speed = reached;
      ++n;
      continue;
    }
    up = way_down(up, n, speed, reached, end);
    n = up.from;
    speed = up.entry;
    run = {};
  }
  if (up.from < end) set_section(up.from, end, up.entry, speed);
}

// All, or whole sections up to the middle, but at least one.
void LookAhead::release(bool ended) {
  const std::uint64_t begin = std::max(planned_, items_.begin());
  const std::uint64_t end = items_.end();
  const std::uint64_t middle = begin + (end - begin) / 2;
  planned_ = begin;
  while (planned_ < end && (ended || planned_ < middle)) {
    const Item& item = items_[planned_];
    const std::uint64_t next = planned_ + item.items;
    if (!ended && next > middle && planned_ > begin) break;
    entry_ = item.section.exit;
    planned_ = next;
  }
}

void LookAhead::take(Section& section) {
  section = items_.front().section;
  const std::uint32_t items = items_.front().items;
  items_.pop();
  if (items == 1) return;
  Run run{section.length, section.limits};
  for (std::uint32_t i = 1; i < items; ++i) {
    const Section& next = items_.front().section;
    run.add(next);
    section.cells += next.cells;
    section.tail = next.tail;
    section.stop = next.stop;
    items_.pop();
  }
  section.length = run.length;
  section.limits = run.limits;
}

}  // namespace kerf::planner
