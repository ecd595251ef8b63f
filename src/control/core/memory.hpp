#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/axes.hpp"

namespace kerf::control {

/// One row of the tool offset table, mm. Memory A uses only length_geometry, memory B the length
/// pair; both serve H and D then.
struct ToolOffset {
  double length_geometry = 0;
  double length_wear = 0;
  double radius_geometry = 0;
  double radius_wear = 0;
  friend bool operator==(const ToolOffset&, const ToolOffset&) = default;
};

/// One row of a lathe's tool offset table, as the operator enters it: mm, X as a diameter. What is
/// in force is geometry and wear together.
struct TurningOffset {
  struct Part {
    double x = 0;
    double y = 0;
    double z = 0;
    double radius = 0;  ///< of the nose
    friend bool operator==(const Part&, const Part&) = default;
  };
  Part geometry;
  Part wear;
  double tip = 0;  ///< direction of the imaginary tip, a whole number from 0 to 9
  friend bool operator==(const TurningOffset&, const TurningOffset&) = default;
};

/// The nose of a turning tool in force: its radius, mm, and the direction of its imaginary tip.
struct Nose {
  double radius_mm = 0;
  int tip = 0;  ///< 0 to 9
};

/// Common variables: #100 to #199, which a reset empties, then #500 to #999.
inline constexpr std::size_t kVolatileCommons = 100;
inline constexpr std::size_t kCommons = kVolatileCommons + 500;

inline constexpr std::size_t kWorkSystems = 6;        ///< G54 to G59
inline constexpr std::size_t kExtendedSystems = 300;  ///< G54.1 P1 to P300

/// What survives power-off, and the volatile common variables beside it. Lengths in mm, machine
/// axes; where programs say diameters, so do the offsets.
struct Memory {
  std::array<double, kCommons> commons{};  ///< vm::kNull: vacant
  base::AxisVector external;               ///< EXT
  std::array<base::AxisVector, kWorkSystems> work{};
  std::vector<base::AxisVector> extended = std::vector<base::AxisVector>(kExtendedSystems);
  std::vector<ToolOffset> tools;       ///< index 1 to n_offsets; entry 0 is "no offset" and stays 0
  std::vector<TurningOffset> turning;  ///< of lathes, likewise
  double parts = 0;                    ///< #3901
  double parts_required = 0;           ///< #3902
  double running_hours = 0;            ///< #3002
  std::map<std::string, std::uint32_t> names;  ///< of SETVN
  /// Whoever changes anything but the commons counts it here, so that whoever keeps images of the
  /// memory need not compare all of it.
  std::uint64_t revision = 0;

  explicit Memory(int n_offsets);

  /// The nose of an offset by its number, with the geometry of a number of its own (LGN); a number
  /// beyond the table has none.
  [[nodiscard]] Nose nose(std::size_t offset, std::size_t geometry) const;

  /// #100 to #199 become vacant.
  void clear_volatile();
};

}  // namespace kerf::control
