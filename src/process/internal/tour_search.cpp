#include "process/internal/tour_search.hpp"

#include <algorithm>

namespace kerf::process::ordering {
namespace {

constexpr double kLeastGain_mm = 1e-7;
constexpr std::uint32_t kLongest = 25'000;
/// Of a stretch whose items must be looked at one by one.
constexpr std::uint32_t kLongestWalked = 1000;
constexpr std::uint32_t kLongestShaken = 1000;
constexpr std::uint32_t kMostTogether = 3;
constexpr std::size_t kVisits = 60;  // of an item
constexpr std::uint32_t kShakenStretch = 40;

/// The same numbers on every computer (xorshift).
class Dice {
 public:
  std::uint32_t below(std::uint32_t end) {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return static_cast<std::uint32_t>((state_ >> 32U) % end);
  }

 private:
  std::uint64_t state_ = 0x9E3779B97F4A7C15U;
};

}  // namespace

TourSearch::TourSearch(Tour& tour, const Neighbours& neighbours)
    : tour_(tour),
      items_(tour.items()),
      neighbours_(neighbours),
      longest_(items_.have_precedence() || !items_.are_symmetric() ? kLongestWalked : kLongest),
      waits_(tour.size()) {}

void TourSearch::queue(std::uint32_t place) {
  if (place < 1 || place > tour_.size() || waits_[tour_[place].item]) return;
  waits_[tour_[place].item] = true;
  waiting_.push_back(tour_[place].item);
}

void TourSearch::settle() {
  for (std::uint32_t place = 1; place <= tour_.size(); ++place) queue(place);
  budget_ = kVisits * tour_.size();
  work_off();
}

double TourSearch::work_off() {
  double gain = 0;
  for (; next_ < waiting_.size(); ++next_) {
    const std::uint32_t item = waiting_[next_];
    waits_[item] = false;
    while (budget_ > 0) {
      --budget_;
      const double more = improve(item);
      if (more <= 0) break;
      gain += more;
    }
  }
  waiting_.clear();
  next_ = 0;
  return gain;
}

double TourSearch::improve(std::uint32_t item) {
  if (const double gain = better_entry(item); gain > 0) return gain;
  if (const double gain = better_reversal(item); gain > 0) return gain;
  return better_place(item);
}

double TourSearch::better_entry(std::uint32_t item) {
  if (items_.end_entry(item) - items_.first_entry(item) < 2) return 0;
  const std::uint32_t place = tour_.place(item);
  const Vec2 from = tour_[place - 1].end;
  double least = tour_.gap(place - 1) + tour_.gap(place) - kLeastGain_mm;
  const double now = least + kLeastGain_mm;
  std::uint32_t best = kNone;
  for (std::uint32_t entry = items_.first_entry(item); entry < items_.end_entry(item); ++entry) {
    const Entry& way = items_.entries()[entry];
    const double here = apart(from, way.begin) + tour_.way(way.end, place + 1);
    if (here < least) least = here, best = entry;
  }
  if (best == kNone) return 0;
  tour_.enter(place, best);
  queue(place - 1);
  queue(place + 1);
  return now - least;
}

double TourSearch::better_reversal(std::uint32_t item) {
  const std::uint32_t place = tour_.place(item);
  const double behind = tour_.gap(place);
  for (const std::uint32_t near : neighbours_.near_end(tour_[place].entry)) {
    const std::uint32_t other = tour_.place(near);
    if (apart(tour_[place].end, tour_[other].end) >= behind) continue;
    if (const double gain = reversal_between(place, other); gain > 0) return gain;
  }
  const double ahead = tour_.gap(place - 1);
  for (const std::uint32_t near : neighbours_.near_begin(tour_[place].entry)) {
    const std::uint32_t other = tour_.place(near);
    if (apart(tour_[place].begin, tour_[other].begin) >= ahead) continue;
    if (const double gain = reversal_between(place - 1, other - 1); gain > 0) return gain;
  }
  return 0;
}

/// The ends of both places come together, and what begins behind them.
double TourSearch::reversal_between(std::uint32_t one, std::uint32_t other) {
  const Stretch stretch{std::min(one, other) + 1, std::max(one, other)};
  if (stretch.first > stretch.last || stretch.size() > longest_) return 0;
  const double gain = saved_by_turning(stretch);
  if (gain <= kLeastGain_mm || !may_turn(stretch)) return 0;
  tour_.reverse(stretch.first, stretch.last);
  for (const std::uint32_t place :
       {stretch.first - 1, stretch.first, stretch.last, stretch.last + 1})
    queue(place);
  return gain;
}

double TourSearch::saved_by_turning(Stretch stretch) const {
  double gain = tour_.gap(stretch.first - 1) + tour_.gap(stretch.last) -
                apart(tour_[stretch.first - 1].end, tour_.turned(stretch.last).begin) -
                tour_.way(tour_.turned(stretch.first).end, stretch.last + 1);
  if (items_.are_symmetric() || gain <= kLeastGain_mm) return gain;
  for (std::uint32_t place = stretch.first; place < stretch.last; ++place) {
    gain += tour_.gap(place) - apart(tour_.turned(place + 1).end, tour_.turned(place).begin);
  }
  return gain;
}

double TourSearch::better_place(std::uint32_t item) {
  const std::uint32_t place = tour_.place(item);
  Placing best;
  for (std::uint32_t more = 0; more < kMostTogether; ++more) {
    if (place + more <= tour_.size()) place_near({place, place + more}, true, best);
    if (place > more) place_near({place - more, place}, false, best);
  }
  if (best.gain <= kLeastGain_mm) return 0;
  carry_out(best);
  return best.gain;
}

/// Beside items that are near one of its ends.
void TourSearch::place_near(Stretch stretch, bool by_first, Placing& best) const {
  const std::uint32_t ahead = stretch.first - 1;
  const double open = tour_.gap(ahead) + tour_.gap(stretch.last);
  const double freed = open - tour_.way(tour_[ahead].end, stretch.last + 1);
  if (freed <= best.gain + kLeastGain_mm) return;
  const Stop& stop = tour_[by_first ? stretch.first : stretch.last];
  const Vec2 at = by_first ? stop.begin : stop.end;
  for (const std::uint32_t near :
       by_first ? neighbours_.near_begin(stop.entry) : neighbours_.near_end(stop.entry)) {
    const std::uint32_t other = tour_.place(near);
    if (stretch.has(other)) continue;
    if (apart(at, tour_[other].end) < open) compare(stretch, other, !by_first, freed, best);
    if (apart(at, tour_[other].begin) < open) compare(stretch, other - 1, by_first, freed, best);
  }
}

void TourSearch::compare(Stretch stretch, std::uint32_t target, bool is_turned, double freed,
                         Placing& best) const {
  if (stretch.has(target) || target + 1 == stretch.first) return;
  const std::uint32_t over =
      target > stretch.last ? target - stretch.last : stretch.first - target - 1;
  if (over > longest_) return;
  const Vec2 begin = is_turned ? tour_.turned(stretch.last).begin : tour_[stretch.first].begin;
  const Vec2 end = is_turned ? tour_.turned(stretch.first).end : tour_[stretch.last].end;
  double gain =
      freed + tour_.gap(target) - apart(tour_[target].end, begin) - tour_.way(end, target + 1);
  if (is_turned && !items_.are_symmetric()) {
    for (std::uint32_t place = stretch.first; place < stretch.last; ++place)
      gain += tour_.gap(place) - apart(tour_.turned(place + 1).end, tour_.turned(place).begin);
  }
  const Placing placing{gain, stretch, target, is_turned};
  if (gain > best.gain + kLeastGain_mm && may_place(placing)) best = placing;
}

void TourSearch::carry_out(const Placing& placing) {
  const Stretch from = placing.stretch;
  const bool goes_on = placing.target > from.last;
  if (placing.is_turned) tour_.reverse(from.first, from.last);
  if (goes_on) {
    tour_.swap(from.first, from.last + 1, placing.target + 1);
  } else {
    tour_.swap(placing.target + 1, from.first, from.last + 1);
  }
  const std::uint32_t first = goes_on ? placing.target + 1 - from.size() : placing.target + 1;
  const std::uint32_t left = goes_on ? from.first : from.last + 1;  // where it was
  for (const std::uint32_t place :
       {first - 1, first, first + from.size() - 1, first + from.size(), left - 1, left})
    queue(place);
}

bool TourSearch::may_turn(Stretch stretch) const {
  if (!items_.have_precedence()) return true;
  for (std::uint32_t place = stretch.first; place <= stretch.last; ++place) {
    for (const std::uint32_t later : items_.after(tour_[place].item)) {
      if (stretch.has(tour_.place(later))) return false;
    }
  }
  return true;
}

/// Whether nothing in [middle, end) has something in [first, middle) that must be made before it.
bool TourSearch::may_swap(std::uint32_t first, std::uint32_t middle, std::uint32_t end) const {
  if (!items_.have_precedence()) return true;
  for (std::uint32_t place = first; place < middle; ++place) {
    for (const std::uint32_t later : items_.after(tour_[place].item)) {
      if (Stretch{middle, end - 1}.has(tour_.place(later))) return false;
    }
  }
  return true;
}

bool TourSearch::may_place(const Placing& placing) const {
  const Stretch from = placing.stretch;
  if (placing.is_turned && !may_turn(from)) return false;
  return placing.target > from.last ? may_swap(from.first, from.last + 1, placing.target + 1)
                                    : may_swap(placing.target + 1, from.first, from.last + 1);
}

/// Two stretches change their places: [first, one) and [one, other).
void TourSearch::shake_at(std::uint32_t first, std::uint32_t one, std::uint32_t other) {
  if (!may_swap(first, one, other)) return;
  const double before = tour_.gap(first - 1) + tour_.gap(one - 1) + tour_.gap(other - 1);
  tour_.mark();
  tour_.swap(first, one, other);
  const std::uint32_t middle = first + (other - one);
  const double gain = before - tour_.gap(first - 1) - tour_.gap(middle - 1) - tour_.gap(other - 1);
  for (const std::uint32_t place : {first - 1, first, middle - 1, middle, other - 1, other})
    queue(place);
  budget_ = kVisits;
  if (gain + work_off() < kLeastGain_mm) tour_.back_to_mark();
}

void TourSearch::shake(std::size_t times) {
  if (tour_.size() < 4) return;
  longest_ = std::min(longest_, kLongestShaken);
  Dice dice;
  const std::uint32_t most = std::min(kShakenStretch, tour_.size() / 2);
  for (std::size_t i = 0; i < times; ++i) {
    const std::uint32_t one = 1 + dice.below(most);
    const std::uint32_t other = 1 + dice.below(most);
    const std::uint32_t first = 1 + dice.below(tour_.size() + 1 - one - other);
    shake_at(first, first + one, first + one + other);
  }
}

}  // namespace kerf::process::ordering
