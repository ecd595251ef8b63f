#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf::stock::replay {

/// How far steps are done at a time: those before `whole`, and of the motion of the steps from
/// there to `end` this share of its way.
struct Instant {
  std::size_t whole = 0;
  std::size_t end = 0;
  double share = 0;  ///< in [0, 1); 0: nothing of it

  friend bool operator==(const Instant&, const Instant&) = default;
};

/// When the steps of a run are done, motion by motion.
class Timeline {
 public:
  /// A motion whose steps end before step `end`, behind those told before; s of the run, rising.
  void add(double start_s, double end_s, std::size_t end);
  /// Nothing comes behind this.
  void reach(double time_s) { reached_s_ = time_s; }

  /// Up to here all is known, s of the run.
  [[nodiscard]] double reached_s() const { return reached_s_; }
  /// What is told up to there where the time is later.
  [[nodiscard]] Instant at(double time_s) const;
  [[nodiscard]] std::size_t bytes() const { return motions_.capacity() * sizeof(Motion); }

 private:
  struct Motion {
    double end_s;
    float lasts_s;
    std::uint32_t end;
  };

  std::vector<Motion> motions_;
  double reached_s_ = 0;
};

}  // namespace kerf::stock::replay
