#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kerf::stock {

/// A number that is said of a tool (stock.md §1). mm and degrees; angles are included angles, what
/// is called a diameter is one.
enum class Measure : std::uint8_t {
  diameter,        ///< of the cutting part
  length,          ///< gauge line of the spindle to the tip
  flute_length,    ///< cutting part, from the tip along the axis
  stickout,        ///< tip to the lower face of the holder
  flutes,          ///< teeth round the axis
  corner_radius,   ///< of mills and grooving inserts
  core_diameter,   ///< within it the face does not cut
  angle,           ///< of a point; of a dovetail from the flank to the face
  tip_diameter,    ///< of a cone
  tip_radius,      ///< of a cone that ends in a ball
  pilot_diameter,  ///< of a centre drill
  pilot_length,    ///< of a centre drill, with its point
  lead,            ///< of a reamer, at 45°
  pitch,
  entering_angle,  ///< κ of a face mill
  ap_max,          ///< height of its edges
  body_diameter,   ///< of a face mill, above them
  width,           ///< of a disc, of a ring, of a grooving insert
  neck_diameter,
  height,         ///< of the flank of a dovetail
  profile_angle,  ///< of a thread
  teeth,          ///< along the axis
  nose_radius,
  tip_angle,  ///< ε
  ic,         ///< inscribed circle
  kapr,       ///< κ: from the direction of the feed to the main edge
  tip,        ///< direction of the imaginary tip, 0 to 9
  minimum_bore,
  overhang,
  holder_width,
};
inline constexpr std::size_t kMeasures = 30;

[[nodiscard]] constexpr std::size_t index(Measure measure) {
  return static_cast<std::size_t>(measure);
}

/// What files call a measure, and the numbers that it takes.
struct MeasureRow {
  Measure measure;
  std::string_view name;
  double low;
  double high;
  bool low_too = true;  ///< whether `low` is one of the numbers
  bool whole = false;

  [[nodiscard]] bool takes(double value) const;
  /// For a sentence: "a number above 0 up to 10000".
  [[nodiscard]] std::string in_words() const;
};

[[nodiscard]] const MeasureRow& row_of(Measure measure);
[[nodiscard]] std::span<const MeasureRow> measure_rows();
/// Null: there is none of this name.
[[nodiscard]] const MeasureRow* measure_named(std::string_view name);

/// What is known of a tool.
class Measures {
 public:
  [[nodiscard]] std::optional<double> get(Measure measure) const { return values_[index(measure)]; }
  void set(Measure measure, double value) { values_[index(measure)] = value; }
  void forget(Measure measure) { values_[index(measure)].reset(); }
  friend bool operator==(const Measures&, const Measures&) = default;

 private:
  std::array<std::optional<double>, kMeasures> values_{};
};

}  // namespace kerf::stock
