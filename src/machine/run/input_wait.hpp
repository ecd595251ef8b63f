#pragma once

#include <cstdint>

namespace kerf::machine {

/// Whether a program waits for an input signal: it reads inputs again and again and moves nothing.
/// Counted, and by the time of the run: the same program has the same answer. Value type.
class InputWait {
 public:
  static constexpr std::uint64_t kMostReads = 10'000;  ///< as a loop without a dwell
  static constexpr double kMost_s = 300;  ///< as a loop with one, of at least kFewReads
  static constexpr std::uint64_t kFewReads = 50;

  /// An input is read at this time of the run.
  void read(double time_s) {
    if (reads_++ == 0) began_s_ = time_s;
    waited_s_ = time_s - began_s_;
    any_ = true;
  }
  void moved() { reads_ = 0; }

  [[nodiscard]] bool waits() const {
    return reads_ >= kMostReads || (reads_ >= kFewReads && waited_s_ >= kMost_s);
  }
  /// An input was read at all.
  [[nodiscard]] bool any() const { return any_; }

 private:
  std::uint64_t reads_ = 0;  // since the last move
  double began_s_ = 0;
  double waited_s_ = 0;
  bool any_ = false;
};

}  // namespace kerf::machine
