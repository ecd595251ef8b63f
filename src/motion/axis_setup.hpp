#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "base/point.hpp"
#include "motion/spindle_name.hpp"

namespace kerf::motion {

/// What the control knows of one axis.
struct AxisConfig {
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  char letter = 'X';
  bool rotary = false;         ///< degrees instead of millimetres
  bool diameter = false;       ///< programs and records say twice the way from the centre
  double rapid_per_min = 0;    ///< mm/min or degrees/min, > 0
  double acceleration = 1000;  ///< mm/s² or degrees/s², > 0
  double jerk = kNoLimit;      ///< mm/s³ or degrees/s³, > 0
  double travel_min = 0;       ///< machine coordinates; used when min < max
  double travel_max = 0;
  std::array<double, 4> reference{};  ///< 1st to 4th reference point, machine coordinates

  /// What people count while the axis moves by 1.
  [[nodiscard]] double count_per_mm() const { return diameter ? 2 : 1; }
};

/// How fast work that turns about X0 Y0 under the tip can be brought to a place, > 0.
struct TurningWork {
  double radius_per_min = 0;  ///< of the tip from the axis, mm/min
  double angle_per_min = 0;   ///< of the work, degrees/min
};

/// The axes of a machine in its order; the position in the list is the Axis. At most kMaxAxes.
struct AxisSetup {
  std::vector<AxisConfig> axes;
  base::TipPoint start;  ///< where they stand at power-on, with no length in force
  bool linked = false;   ///< others move them through a linkage, which not every move suits
  bool beam = false;     ///< for a spindle there is the beam of a laser
  /// Rapids bring the axes from point to point (TurningRapid); nothing: they go straight.
  std::optional<TurningWork> turning_work;
  /// Of each spindle, rpm/s; 0: a change of its speed takes no time.
  std::array<double, kSpindles> spindle_acceleration{};
  /// What feeds per revolution count while no spindle has had a speed, rpm; 0: no time is known.
  double standing_rpm = 0;

  [[nodiscard]] std::size_t count() const { return axes.size(); }
  [[nodiscard]] const AxisConfig& operator[](base::Axis axis) const { return axes[index(axis)]; }
  /// A lathe: what people say of X is a diameter.
  [[nodiscard]] bool turns() const {
    const auto x = find('X');
    return x && (*this)[*x].diameter;
  }
  /// A point or way as people count it, and the other way round.
  [[nodiscard]] base::AxisVector counted(base::AxisVector mm) const {
    for (std::size_t i = 0; i < axes.size(); ++i) mm.values[i] *= axes[i].count_per_mm();
    return mm;
  }
  [[nodiscard]] base::AxisVector in_mm(base::AxisVector counted) const {
    for (std::size_t i = 0; i < axes.size(); ++i) counted.values[i] /= axes[i].count_per_mm();
    return counted;
  }
  [[nodiscard]] std::optional<base::Axis> find(char letter) const {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (axes[i].letter == letter) return base::Axis{static_cast<std::uint8_t>(i)};
    }
    return std::nullopt;
  }
};

}  // namespace kerf::motion
