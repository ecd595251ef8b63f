#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "geometry/vec3.hpp"

namespace kerf::teach {

/// Where the beam was when a point was taught: its focus, and tilt A and turn C of the head. mm and
/// degrees, machine coordinates.
struct Pose {
  double x = 0;
  double y = 0;
  double z = 0;
  double a_deg = 0;
  double c_deg = 0;

  [[nodiscard]] geometry::Vec3 focus() const { return {x, y, z}; }
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// Name of a taught point; text that is longer is cut off.
class Name {
 public:
  static constexpr std::size_t kMost = 63;  ///< bytes
  Name() = default;
  explicit Name(std::string_view text)
      : size_(static_cast<std::uint8_t>(std::min(text.size(), kMost))) {
    std::copy_n(text.data(), size_, bytes_.data());
  }
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }
  friend bool operator==(const Name& a, const Name& b) { return a.view() == b.view(); }

 private:
  std::array<char, kMost> bytes_{};
  std::uint8_t size_ = 0;
};

// The records of a .tch file (docs/teach.md), in the order in which one usually meets them. Plain
// values; ranges are those that record_parser accepts.

/// TEACH 1: the first record of every file.
struct Version {
  friend bool operator==(const Version&, const Version&) = default;
};

/// UNITS MM DEG: there are no others.
struct Units {
  friend bool operator==(const Units&, const Units&) = default;
};

/// Period of the servo that the points were taught for.
struct Period {
  double milliseconds = 8;  ///< > 0
  friend bool operator==(const Period&, const Period&) = default;
};

/// Lengths of the head that the points were taught with.
struct Radii {
  double r_a_mm = 0;
  double r_c_mm = 0;
  friend bool operator==(const Radii&, const Radii&) = default;
};

/// Start of a path, or a rapid to the start of the next one.
struct Point {
  Pose to;
  Name name;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Feed of all cuts that follow.
struct Feed {
  double mm_per_min = 0;  ///< > 0
  friend bool operator==(const Feed&, const Feed&) = default;
};

/// The beam from here on.
struct Laser {
  bool on = false;
  std::optional<double> percent;  ///< of full power, 0 to 100; without it as before, 100 at first
  friend bool operator==(const Laser&, const Laser&) = default;
};

struct Line {
  Pose to;
  friend bool operator==(const Line&, const Line&) = default;
};

/// Along the circle through three points: where the beam is, `via`, `to`.
struct Arc {
  Pose via;
  Pose to;
  friend bool operator==(const Arc&, const Arc&) = default;
};

/// Once round through both points, and back to where the beam is.
struct Circle {
  Pose via;
  Pose second_via;
  friend bool operator==(const Circle&, const Circle&) = default;
};

struct Dwell {
  double seconds = 0;  ///< >= 0
  friend bool operator==(const Dwell&, const Dwell&) = default;
};

struct End {
  friend bool operator==(const End&, const End&) = default;
};

/// One line of the file.
using Record =
    std::variant<Version, Units, Period, Radii, Point, Feed, Laser, Line, Arc, Circle, Dwell, End>;

}  // namespace kerf::teach
