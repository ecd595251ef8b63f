#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "control/core/parameters.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// A G code times ten: G54.1 is 541.
using GCode = std::uint16_t;

/// Groups of the machining centre (docs/dialect.md §3.2, §8.1).
enum class Group : std::uint8_t {
  one_shot = 0,
  motion = 1,
  plane = 2,
  distance = 3,
  stroke = 4,
  feed = 5,
  unit = 6,
  compensation = 7,
  length = 8,
  cycle = 9,
  cycle_return = 10,
  scaling = 11,
  modal_call = 12,
  speed = 13,
  work = 14,
  stop_mode = 15,
  rotation = 16,
  polar = 17,
  normal_direction = 19,
  in_feed = 20,
  polar_interpolation = 21,
  mirror = 22,
  none = 255  ///< the code does not exist
};
inline constexpr std::size_t kGroups = 23;

[[nodiscard]] Group group_of(GCode code);

/// "G01", "G54.1".
[[nodiscard]] std::string name_of(GCode code);

/// The modal G codes of all groups. Value type.
class ModalState {
 public:
  explicit ModalState(const Parameters& parameters);

  [[nodiscard]] GCode operator[](Group group) const {
    return codes_[static_cast<std::size_t>(group)];
  }
  void set(Group group, GCode code) { codes_[static_cast<std::size_t>(group)] = code; }

  [[nodiscard]] bool incremental() const { return (*this)[Group::distance] == 910; }
  [[nodiscard]] bool inch() const { return (*this)[Group::unit] == 200; }
  [[nodiscard]] bool compensating() const { return (*this)[Group::compensation] != 400; }
  [[nodiscard]] bool in_cycle() const { return (*this)[Group::cycle] != 800; }
  [[nodiscard]] motion::Plane plane() const {
    const GCode code = (*this)[Group::plane];
    return code == 180 ? motion::Plane::zx : code == 190 ? motion::Plane::yz : motion::Plane::xy;
  }
  [[nodiscard]] motion::FeedMode feed_mode() const {
    const GCode code = (*this)[Group::feed];
    return code == 950   ? motion::FeedMode::per_revolution
           : code == 930 ? motion::FeedMode::inverse_time
                         : motion::FeedMode::per_minute;
  }
  /// All of them, in the order of the groups.
  [[nodiscard]] const std::array<GCode, kGroups>& codes() const { return codes_; }
  /// Value of #4001 + number - 1, or a negative number when there is no such group.
  [[nodiscard]] double variable(std::size_t group_number) const;

 private:
  std::array<GCode, kGroups> codes_{};
};

}  // namespace kerf::control
