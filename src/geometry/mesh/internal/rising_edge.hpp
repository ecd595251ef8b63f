#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kerf::mesh {

/// The places of lines along one coordinate, whole numbers of quanta, rising.
class Places {
 public:
  explicit Places(std::span<const double> places_mm);

  [[nodiscard]] std::size_t count() const { return at_.size(); }
  [[nodiscard]] std::int64_t operator[](std::size_t i) const { return at_[i]; }
  /// About the number of the first place that is not below this, at most count(): where to begin
  /// to look for it.
  [[nodiscard]] std::size_t near(double place) const;
  /// The number of the first place that is not below this.
  [[nodiscard]] std::size_t from(std::int64_t place) const;

 private:
  std::vector<std::int64_t> at_;
  double per_quantum_ = 0;
};

/// A multiple of Lines::kQuantum_mm, as its number.
[[nodiscard]] std::int64_t quanta(double mm);

/// A corner as lines see it: b and c in quanta across them, s along them, mm.
struct SeenCorner {
  std::int64_t b = 0;
  std::int64_t c = 0;
  double s = 0;
};

/// An edge that rises in c. A row meets it from its lower corner on and below the upper one.
class RisingEdge {
 public:
  /// Precondition: low.c < high.c.
  RisingEdge(const SeenCorner& low, const SeenCorner& high) : low_(low), high_(high) {}

  [[nodiscard]] bool meets(std::int64_t c) const { return low_.c <= c && c < high_.c; }
  /// Number of the first line of a row that stands on the side of larger b, by Lines' rule.
  [[nodiscard]] std::size_t first_beyond(const Places& columns, std::int64_t c) const;
  /// Where the edge is in a row.
  [[nodiscard]] double b_at(std::int64_t c) const;
  [[nodiscard]] double s_at(std::int64_t c) const;

 private:
  [[nodiscard]] double share(std::int64_t c) const;
  [[nodiscard]] bool is_beyond(std::int64_t b, std::int64_t c) const;

  SeenCorner low_;
  SeenCorner high_;
};

}  // namespace kerf::mesh
