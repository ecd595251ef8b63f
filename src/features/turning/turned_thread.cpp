#include "features/turning/turned_thread.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"
#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::features {
namespace {

constexpr double kUsualAngle_deg = 60;
constexpr double kSameAngle_deg = 0.5;

/// The row of a chain that is in step with the spindle.
std::uint32_t thread_row(const Recording& recording, Span rows) {
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (recording.moves[row].kind == Move::Kind::thread) return row;
  }
  return rows.first;
}

std::uint32_t last_thread_row(const Recording& recording, Span rows) {
  std::uint32_t last = thread_row(recording, rows);
  for (std::uint32_t row = last; row <= rows.last; ++row) {
    if (recording.moves[row].kind == Move::Kind::thread) last = row;
  }
  return last;
}

// A pass may leave the material by a way out of its own, which is no part of its depth.
double deepest_x(const Recording& recording, Span rows, bool is_outer) {
  const std::uint32_t first = thread_row(recording, rows);
  double x = recording.moves[first].to.x;
  for (std::uint32_t row = first; row <= last_thread_row(recording, rows); ++row) {
    if (recording.moves[row].kind != Move::Kind::thread) continue;
    const double its = recording.moves[row].to.x;
    x = is_outer ? std::min(x, its) : std::max(x, its);
  }
  return x;
}

const State& state_at(const Recording& recording, std::uint32_t row) {
  return recording.state_of(recording.moves[row]);
}

/// Where on the lead a pass begins, degrees: by its angle of the spindle and by its way along Z.
double place_on_lead(const Recording& recording, std::uint32_t row, double end_z) {
  const State& state = state_at(recording, row);
  if (state.lead <= 0) return 0;
  double place = state.start_deg + 360 * (recording.from(row).z - end_z) / state.lead;
  place = std::fmod(place, 360);
  return place < 0 ? place + 360 : place;
}

int starts_of(const std::vector<double>& places) {
  std::vector<double> apart;
  for (const double place : places) {
    const bool is_known = std::any_of(apart.begin(), apart.end(), [&](double other) {
      const double off = std::fabs(place - other);
      return std::min(off, 360 - off) <= kSameAngle_deg;
    });
    if (!is_known) apart.push_back(place);
  }
  return static_cast<int>(apart.size());
}

// A thread is a groove of triangles: the section times the way of its middle round the axis.
double volume_of(const TurnedPart::Thread& thread, double length, double angle_deg) {
  const double height = (thread.major - thread.minor) / 2;
  const double section = height * height * math::tan(geometry::radians(angle_deg) / 2);
  const double middle = thread.major / 2 - height / 3;
  return section * 2 * std::numbers::pi * middle * length / thread.pitch;
}

}  // namespace

bool is_same_thread(const Recording& recording, const TurnedDraft& draft, const TurnedChain& more) {
  const std::uint32_t a = thread_row(recording, draft.chains.back().chain.rows);
  const std::uint32_t b = thread_row(recording, more.chain.rows);
  const double end_a =
      recording.moves[last_thread_row(recording, draft.chains.back().chain.rows)].to.z;
  const double end_b = recording.moves[last_thread_row(recording, more.chain.rows)].to.z;
  const double lead = state_at(recording, a).lead;
  return draft.chains.back().operation == more.operation &&
         std::fabs(lead - state_at(recording, b).lead) <= kSamePoint_mm &&
         std::fabs(end_a - end_b) < lead;
}

void finish_thread(const Recording& recording, const HalfSection& material, const stock::Tool& tool,
                   TurnedDraft& draft) {
  Feature& feature = draft.feature;
  TurnedPart& part = feature.turned.emplace();
  part.outer = draft.chains.front().beyond != Beyond::inside;
  const std::uint32_t row = thread_row(recording, draft.chains.front().chain.rows);
  const std::uint32_t end = last_thread_row(recording, draft.chains.front().chain.rows);
  const Vec3 from = recording.from(row);
  const Vec3 to = recording.moves[end].to;
  const double deepest = deepest_x(recording, draft.chains.front().chain.rows, part.outer);
  std::vector<double> places;
  double least = deepest;
  double most = deepest;
  for (const TurnedChain& chain : draft.chains) {
    const std::uint32_t its = thread_row(recording, chain.chain.rows);
    places.push_back(place_on_lead(recording, its, to.z));
    const double x = deepest_x(recording, chain.chain.rows, part.outer);
    least = std::min(least, x);
    most = std::max(most, x);
    part.passes.push_back({.at = 2 * x, .rows = chain.chain.rows});
  }
  part.thread = TurnedPart::Thread{};
  TurnedPart::Thread& thread = *part.thread;
  const double low = std::min(from.z, to.z);
  const double high = std::max(from.z, to.z);
  const auto radii = material.radii_between(low, high);
  thread.starts = starts_of(places);
  thread.pitch = state_at(recording, row).lead / thread.starts;
  thread.major = 2 * (part.outer ? (radii ? radii->most : most) : most);
  thread.minor = 2 * (part.outer ? least : (radii ? radii->least : least));
  thread.taper = 2 * (recording.moves[row].to.x - from.x);
  const bool turns_back =
      state_at(recording, row).turning == motion::Spindle::Turning::counterclockwise;
  thread.is_left_hand = (to.z > from.z) != turns_back;
  feature.top = from.z;
  feature.bottom = to.z;
  const contour::Box there = contour::extents(material.left());
  const double length = std::max(0.0, std::min(high, there.high.u) - std::max(low, there.low.u));
  const double angle = tool.value(stock::Measure::profile_angle).value_or(kUsualAngle_deg);
  if (thread.pitch > 0) feature.turned_volume = volume_of(thread, length, angle);
  part.contour = {{{recording.flat(from), 0, row}, {recording.flat(to), 0, row}}, false};
  for (const TurnedChain& chain : draft.chains) {
    if (feature.cuts.empty()) feature.cuts.push_back({.operation = chain.operation});
    feature.cuts.front().visits.push_back(chain.chain.visit);
  }
}

}  // namespace kerf::features
