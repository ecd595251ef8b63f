#pragma once

#include <string>

#include "motion/mark.hpp"
#include "output/picture/internal/cut_scale.hpp"

namespace kerf::output::plot {

/// The way from a set-point to the next one.
struct CutPeriod {
  double way_mm = 0;
  double time_s = 0;
  motion::Mark mark;
  float power_percent = 0;  ///< of a laser in this period
};

/// What the colours of cuts say. Takes the periods of a run in order.
class CutMeasure {
 public:
  virtual ~CutMeasure() = default;

  /// Whether the way of this period is drawn.
  [[nodiscard]] virtual bool is_drawn(const motion::Mark& mark) const = 0;
  /// Of a period, drawn or not.
  [[nodiscard]] virtual double take(const CutPeriod& period) = 0;
  /// Of the set-point between two periods.
  [[nodiscard]] virtual double between(double before, double behind) const = 0;
  /// The colours of all that was taken.
  [[nodiscard]] virtual CutScale scale() const = 0;
  /// What the legend says below the colours.
  [[nodiscard]] virtual std::string caption() const = 0;
};

/// How fast the tool went where it moved at feed, mm/min. A beam that is off is known for
/// travelling once it was on.
class SpeedOfCut final : public CutMeasure {
 public:
  [[nodiscard]] bool is_drawn(const motion::Mark& mark) const override;
  [[nodiscard]] double take(const CutPeriod& period) override;
  [[nodiscard]] double between(double before, double behind) const override {
    return (before + behind) / 2;
  }
  [[nodiscard]] CutScale scale() const override { return CutScale::of_speeds(fastest_); }
  [[nodiscard]] std::string caption() const override;

 private:
  double fastest_ = 0;
  bool beam_was_on_ = false;
};

}  // namespace kerf::output::plot
