#pragma once

#include <cmath>
#include <random>

namespace kerf::test {

/// Where the seeds of all random tests begin.
inline constexpr unsigned kSeed = 20260101;

/// Random numbers that are the same on every run.
class SeededRandom {
 public:
  explicit SeededRandom(unsigned seed) : engine_(seed) {}

  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// Between two positive numbers, as often small as large.
  double size(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }
  /// From `low` to `high`, both possible.
  int count(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  bool coin() { return (engine_() & 1U) != 0; }

 private:
  std::mt19937 engine_;
};

}  // namespace kerf::test
