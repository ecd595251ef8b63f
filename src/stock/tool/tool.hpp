#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stock/tool/measure.hpp"
#include "stock/tool/profile.hpp"
#include "stock/tool/tool_kind.hpp"

namespace kerf::stock {

/// A piece of a shank or of a holder, mm: a cylinder, or a cone where the diameters differ.
struct Segment {
  double height = 0;  ///< > 0
  double lower = 0;   ///< diameter below, > 0
  double upper = 0;   ///< diameter above, > 0
  friend bool operator==(const Segment&, const Segment&) = default;
};

/// What the maker of a tool allows; nothing: nothing is known.
struct ToolLimits {
  std::optional<double> fz;        ///< mm a tooth
  std::optional<double> ap;        ///< mm along the axis
  std::optional<double> ae;        ///< mm across it
  std::optional<double> vc;        ///< m/min
  std::optional<double> ramp_deg;  ///< steepest way down
  friend bool operator==(const ToolLimits&, const ToolLimits&) = default;
};

/// A vertex of the outline of a form tool; the bulge is that of the edge that begins here.
struct FormPoint {
  double r = 0;
  double z = 0;
  double bulge = 0;
  friend bool operator==(const FormPoint&, const FormPoint&) = default;
};

/// The edges of a form tool's outline that cut: from this vertex to that.
struct FormCutting {
  std::size_t from = 0;
  std::size_t to = 0;
  friend bool operator==(const FormCutting&, const FormCutting&) = default;
};

enum class Hand : std::uint8_t {
  right,  ///< cuts under M03
  left,   ///< cuts under M04
};

/// Where a driven tool of a lathe stands: along Z before the face of the part, or along X beside
/// it.
enum class Driven : std::uint8_t { face, side };

/// Who has said what a tool is, the one that counts most first (stock.md §1.5).
enum class ToolSource : std::uint8_t { file, machine, comment, offset, assumed };
/// As reports write it: "file".
[[nodiscard]] std::string_view word_of(ToolSource source);

/// A tool of a machine as somebody has described it. Value type. Nothing in it is a guess: where a
/// measure is not said, value() may have a usual one, but said() has none, and a check that needs
/// it must ask said().
struct Tool {
  int number = 0;
  ToolKind kind = ToolKind::flat;
  /// The name of the kind that was used, of static lifetime. Empty: nobody has said the kind.
  std::string_view type{};
  ToolSource source = ToolSource::file;
  std::string name{};
  std::string comment{};
  std::string material{};
  std::string insert{};  ///< ISO 1832 designation
  Measures measures{};
  std::vector<Segment> shank{};   ///< upwards from the end of the flutes
  std::vector<Segment> holder{};  ///< upwards from the stickout
  ToolLimits limits{};
  Hand hand = Hand::right;
  std::optional<bool> centre_cutting{};
  std::optional<Driven> driven{};  ///< nothing: nobody has said where it would stand
  std::vector<FormPoint> form{};
  std::optional<FormCutting> cutting{};

  /// What somebody has said, in numbers or by the designation of the insert.
  [[nodiscard]] std::optional<double> said(Measure measure) const;
  /// That, or else what is usual for the kind. Nothing: neither is known.
  /// The pitch of a tap is that of the coarse series (ISO 261) then.
  [[nodiscard]] std::optional<double> value(Measure measure) const;
  /// For measures that the kind needs or has a default for. Precondition: objection() is empty.
  [[nodiscard]] double operator[](Measure measure) const;

  [[nodiscard]] bool is_insert() const { return row_of(kind).is_insert(); }
  /// The name of its kind for people and reports.
  [[nodiscard]] std::string_view type_name() const;
  /// Radius within which its face does not cut, mm; 0: it cuts at its centre. Nothing: not known.
  [[nodiscard]] std::optional<double> core_mm() const;

  friend bool operator==(const Tool&, const Tool&) = default;
};

/// Why there can be no such tool, or what its kind must know and has not been told: a sentence
/// without a full stop. Empty: it has a shape.
[[nodiscard]] std::string objection(const Tool& tool);

/// The outline of a rotating tool: cutting part, then what nothing cuts with. Without flute_length
/// the cutting part goes up to the holder, or without end; without a shank what follows the flutes
/// is as wide as they are. Precondition: it is no insert and objection() is empty.
[[nodiscard]] Profile profile_of(const Tool& tool);

}  // namespace kerf::stock
