#include "stock/sweep/outcome.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace kerf::stock {
namespace {

constexpr double kPart = 4294967296.0;  // of a unit
constexpr double kMost = 2147483647.0;  // units

// What is small enough has no digits below 1 when it is added to this.
constexpr double kShift = 6755399441055744.0;  // 1.5 · 2⁵²
constexpr double kSmall = 2251799813685248.0;  // 2⁵¹

/// As std::nearbyint(), which not every processor has an instruction for.
double nearest(double value) {
  return std::fabs(value) < kSmall ? (value + kShift) - kShift : std::nearbyint(value);
}

/// Which of two contacts of equal depth keeps its place.
bool comes_first(Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

}  // namespace

Exact::Exact(double value)
    : parts_(static_cast<std::int64_t>(nearest(std::clamp(value, -kMost, kMost) * kPart))) {}

// The digits of a small one stand in those of the sum: no conversion, and several at once.
void Exact::add(std::span<const double> values, double times, double most, Exact* sums) {
  if (times * most * kPart < kSmall) {
    constexpr auto kZero = std::bit_cast<std::int64_t>(kShift);
    for (std::size_t i = 0; i < values.size(); ++i)
      sums[i].parts_ += std::bit_cast<std::int64_t>(times * values[i] * kPart + kShift) - kZero;
  } else {
    for (std::size_t i = 0; i < values.size(); ++i) sums[i] += Exact(times * values[i]);
  }
}

double Exact::value() const { return static_cast<double>(parts_) / kPart; }

void Contact::add(const Contact& other) {
  volume += other.volume;
  if (other.depth_mm < depth_mm) return;
  if (other.depth_mm == depth_mm && !(other.is_one() && comes_first(other.at, at))) return;
  depth_mm = other.depth_mm;
  at = other.at;
}

void Outcome::add(const Outcome& other) {
  removed += other.removed;
  for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].add(other.contacts[i]);
  core += other.core;
  for (std::size_t i = 0; i < across.size(); ++i) across[i] += other.across[i];
  aside.add(other.aside);
  heights.add(other.heights);
  section += other.section;
  threaded += other.threaded;
  visited += other.visited;
}

bool Outcome::has_contact() const {
  return std::any_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.is_one(); });
}

}  // namespace kerf::stock
