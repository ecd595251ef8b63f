#pragma once

#include <span>
#include <vector>

#include "drive/pulse_sink.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "motion/curve.hpp"

namespace kerf::engraver {

/// Measures how far the wheel is from the programmed path after every pulse of an arm: the tip of
/// the counters against the nearest place of the curve that is being cut, in X and Y. Pulses at the
/// same time are one: between them the wheel is nowhere.
class PathGauge : public drive::PulseSink {
 public:
  struct Worst {
    double mm = 0;
    double x = 0, y = 0;  ///< where the wheel is
    double path_x = 0, path_y = 0;
  };

  /// The machine must outlive the gauge; the motors stand at `counts`.
  PathGauge(const machine::PatternMachine& machine, const drive::ArmCounts& counts)
      : machine_(machine), counts_(counts) {}

  /// From now on pulses belong to this curve near `s`; null: nothing is measured. The curve must
  /// stay until the next call.
  void follow(const motion::Curve* curve, double s) {
    curve_ = curve;
    s_ = s;
  }
  void take(const drive::Pulse& pulse) override;

  struct Place {
    double x = 0, y = 0;
  };
  /// What the wheel did since the last call of this.
  [[nodiscard]] Worst take_worst();
  /// Where it stood between the pulses before that call, in order.
  [[nodiscard]] std::span<const Place> places() const { return places_; }

 private:
  void measure();

  const machine::PatternMachine& machine_;
  drive::ArmCounts counts_;
  const motion::Curve* curve_ = nullptr;
  double s_ = 0;        // of the nearest place
  bool moved_ = false;  // since the last measure
  std::int64_t time_ns_ = 0;
  Worst worst_;
  bool begins_ = true;  // the next place is the first one of a step
  std::vector<Place> places_;
};

}  // namespace kerf::engraver
