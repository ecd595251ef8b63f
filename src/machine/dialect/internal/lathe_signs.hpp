#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

#include "machine/dialect/internal/line_words.hpp"

namespace kerf::machine {

/// Where something was seen first, and what it is.
struct SeenSign {
  std::uint32_t line = 0;  ///< from 1; 0: it was not seen
  std::string word;        ///< "G50 S3000"

  void see(std::uint32_t at, std::string_view text) {
    if (line == 0) *this = {at, std::string(text)};
  }
  [[nodiscard]] bool seen() const { return line > 0; }
};

/// The signs of a lathe in a program, weighed against those of a mill. Each kind of sign counts
/// once, so that a habit (T101, F0.2, a G99 in the head) that a mill's programs may have is not
/// enough, however often it comes. Axis words of calls and of data are none. What has a Y is no
/// lathe's.
class LatheSigns {
 public:
  static constexpr std::size_t kMostKinds = 32;

  /// The next line, numbered from 1.
  void read(std::uint32_t number, const LineWords& line);

  /// Whether the program is for a lathe.
  [[nodiscard]] bool is_lathe() const;
  /// The heaviest sign; of equal ones the first.
  [[nodiscard]] const SeenSign& strongest() const { return strongest_; }
  /// What only a lathe can make that turns C as an axis, or drives tools.
  [[nodiscard]] const SeenSign& c_axis() const { return c_axis_; }

 private:
  void weigh(std::uint32_t number, const LineWords& line);
  void see_c_axis(std::uint32_t number, const LineWords& line);
  void see_axes(const LineWords& line);

  std::bitset<kMostKinds> kinds_;
  int points_ = 0;
  int most_points_ = 0;
  SeenSign strongest_, c_axis_;
  bool moves_x_or_z_ = false, moves_y_ = false;
  bool cuts_ = false;  // G01 to G03 are in force, not G00
};

}  // namespace kerf::machine
