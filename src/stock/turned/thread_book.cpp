#include "stock/turned/thread_book.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contour/boolean.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Box;
using contour::Region;
using contour::Vec2;

constexpr double kSameLead_mm = 1e-6;
constexpr double kSameAngle_deg = 1e-3;

char axis_of(const ThreadPass& pass) {
  const Vec2 way = pass.to - pass.from;
  return std::fabs(way.u) >= std::fabs(way.v) ? 'Z' : 'X';
}

double along(Vec2 point, char axis) { return axis == 'Z' ? point.u : point.v; }

void add_angle(std::vector<double>& angles, double degrees) {
  const double angle = std::fmod(std::fmod(degrees, 360) + 360, 360);
  const auto is_same = [&](double known) {
    const double apart = std::fabs(known - angle);
    return std::min(apart, 360 - apart) <= kSameAngle_deg;
  };
  if (std::none_of(angles.begin(), angles.end(), is_same)) angles.push_back(angle);
}

/// The side away from the tool is where the tip went deepest, the other one the border of the part.
void take_diameters(const ThreadPass& pass, const Box& ring, TurnedThread& thread, bool is_new) {
  const double a = 2 * std::fabs(pass.from.v);
  const double b = 2 * std::fabs(pass.to.v);
  if (pass.is_inside) {
    thread.minor = 2 * ring.low.v;
    thread.major = is_new ? std::max(a, b) : std::max({thread.major, a, b});
  } else {
    thread.major = 2 * ring.high.v;
    thread.minor = is_new ? std::min(a, b) : std::min({thread.minor, a, b});
  }
}

}  // namespace

Region ThreadBook::add(const ThreadPass& pass) {
  const char axis = axis_of(pass);
  const Box met = contour::extents(pass.met);
  const double least = along(met.low, axis);
  const double most = along(met.high, axis);
  const double a = std::clamp(along(pass.from, axis), least, most);
  const double b = std::clamp(along(pass.to, axis), least, most);
  Entry& entry = entry_of(pass, axis, std::min(a, b), std::max(a, b));
  const bool is_new = entry.angles.empty();
  Region fresh = is_new ? pass.met : contour::subtract(pass.met, entry.ring);
  entry.ring = is_new ? pass.met : contour::unite(entry.ring, pass.met);
  entry.groove_mm3 = std::max(entry.groove_mm3, pass.groove_mm3);
  if (is_new) entry.is_rising = b > a;
  add_angle(entry.angles, pass.start_deg);
  take_diameters(pass, contour::extents(entry.ring), entry.thread, is_new);
  return fresh;
}

ThreadBook::Entry& ThreadBook::entry_of(const ThreadPass& pass, char axis, double low,
                                        double high) {
  for (Entry& entry : entries_) {
    const TurnedThread& known = entry.thread;
    if (known.body != pass.body || known.axis != axis || known.is_inside != pass.is_inside)
      continue;
    if (std::fabs(entry.lead - pass.lead) > kSameLead_mm) continue;
    if (low > entry.high + pass.lead || high < entry.low - pass.lead) continue;
    entry.low = std::min(entry.low, low);
    entry.high = std::max(entry.high, high);
    return entry;
  }
  Entry entry;
  entry.thread = {
      .body = pass.body, .motion = pass.motion, .axis = axis, .is_inside = pass.is_inside};
  entry.lead = pass.lead;
  entry.low = low;
  entry.high = high;
  entries_.push_back(std::move(entry));
  return entries_.back();
}

std::vector<TurnedThread> ThreadBook::threads() const {
  std::vector<TurnedThread> out;
  for (const Entry& entry : entries_) {
    TurnedThread thread = entry.thread;
    thread.from = entry.is_rising ? entry.low : entry.high;
    thread.to = entry.is_rising ? entry.high : entry.low;
    thread.starts = static_cast<int>(entry.angles.size());
    thread.pitch = entry.lead / thread.starts;
    thread.volume_mm3 = entry.groove_mm3 * thread.starts * (entry.high - entry.low) / entry.lead;
    out.push_back(thread);
  }
  return out;
}

Region ThreadBook::ring(BodyId body) const {
  Region all;
  for (const Entry& entry : entries_) {
    if (entry.thread.body == body) all = contour::unite(all, entry.ring);
  }
  return all;
}

}  // namespace kerf::stock::turned
