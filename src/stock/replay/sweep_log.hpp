#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "stock/sweep/sweep.hpp"

namespace kerf::stock::replay {

/// Sweeps in the order in which they were cut, in little memory: straight ways that go on from each
/// other share their points, and what sweeps have in common is kept once in a row.
class SweepLog {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 30;

  /// Precondition: size() < kMost.
  void add(const Sweep& sweep);
  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] std::uint32_t motion(std::size_t i) const { return records_[i].motion; }
  /// As it was added, to the last bit.
  [[nodiscard]] Sweep operator[](std::size_t i) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  enum class Form : std::uint32_t { straight, arc, turning };
  struct Record {
    std::uint32_t motion;
    std::uint32_t like;   // of likes_
    std::uint32_t place;  // form and number in its list
  };
  /// What a sweep has besides way and motion.
  struct Like {
    Vec3 axis;
    double lead_mm;
    double start_deg;
    BodyId body;
    SweepKind kind;

    friend bool operator==(const Like&, const Like&) = default;
  };

  [[nodiscard]] std::uint32_t place_of(const Way& way);

  std::deque<Record> records_;
  std::deque<Like> likes_;
  std::deque<Vec3> points_;
  std::deque<ArcWay> arcs_;
  std::deque<TurningWay> turnings_;
};

}  // namespace kerf::stock::replay
