#include "geometry/mesh/internal/rising_edge.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "geometry/mesh/lines.hpp"

namespace kerf::mesh {
namespace {

// Differences of quanta have 46 bits, so their products need more than 64.
__extension__ using Wide = __int128;

}  // namespace

std::int64_t quanta(double mm) { return base::round_away(mm / Lines::kQuantum_mm); }

Places::Places(std::span<const double> places_mm) {
  at_.reserve(places_mm.size());
  for (const double place : places_mm) at_.push_back(quanta(place));
  const std::int64_t size = at_.empty() ? 0 : at_.back() - at_.front();
  if (size > 0) per_quantum_ = static_cast<double>(at_.size() - 1) / static_cast<double>(size);
}

std::size_t Places::near(double place) const {
  if (at_.empty()) return 0;
  const double number = std::ceil((place - static_cast<double>(at_.front())) * per_quantum_);
  return static_cast<std::size_t>(std::clamp(number, 0.0, static_cast<double>(at_.size())));
}

std::size_t Places::from(std::int64_t place) const {
  std::size_t i = near(static_cast<double>(place));
  while (i > 0 && at_[i - 1] >= place) --i;
  while (i < at_.size() && at_[i] < place) ++i;
  return i;
}

/// The line stands a little further than (b, c): along c by e, along b by e². On the edge itself
/// the edge goes away to larger b by e·slope, so the line is beyond it unless the slope is
/// positive.
bool RisingEdge::is_beyond(std::int64_t b, std::int64_t c) const {
  const Wide line = Wide{b - low_.b} * (high_.c - low_.c);
  const Wide edge = Wide{c - low_.c} * (high_.b - low_.b);
  return line > edge || (line == edge && high_.b <= low_.b);
}

std::size_t RisingEdge::first_beyond(const Places& columns, std::int64_t c) const {
  std::size_t i = columns.near(b_at(c));
  while (i > 0 && is_beyond(columns[i - 1], c)) --i;
  while (i < columns.count() && !is_beyond(columns[i], c)) ++i;
  return i;
}

double RisingEdge::share(std::int64_t c) const {
  return static_cast<double>(c - low_.c) / static_cast<double>(high_.c - low_.c);
}

double RisingEdge::b_at(std::int64_t c) const {
  return static_cast<double>(low_.b) + share(c) * static_cast<double>(high_.b - low_.b);
}

double RisingEdge::s_at(std::int64_t c) const { return low_.s + share(c) * (high_.s - low_.s); }

}  // namespace kerf::mesh
