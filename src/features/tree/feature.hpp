#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "features/path/modes.hpp"
#include "features/path/recording.hpp"
#include "features/tree/hole_step.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

using contour::Contour;

/// What a feature is. The last ones are a lathe's.
enum class FeatureType : std::uint8_t {
  thread,
  surface,
  chamfer,
  engraving,
  slot,
  groove,
  face,
  outside_profile,
  inside_profile,
  boss,
  pocket,
  step,
  open_pocket,
  facing,
  turning,
  boring,
  face_groove,
  parting,
  drilling,
};

/// Whether features of a type are levels of a mill with their regions; others are rows alone.
[[nodiscard]] constexpr bool has_levels(FeatureType type) {
  return type != FeatureType::surface && type != FeatureType::thread;
}

/// In which order the loops of a layer were cut, by the lengths of the first and the last one.
enum class Order : std::uint8_t { undefined, inside_out, outside_in };

/// How a region was cleared.
enum class Strategy : std::uint8_t {
  single,            ///< one pass or loop
  contour_parallel,  ///< closed loops and their links, nothing else
  zig,               ///< parallel lines in one sense
  zig_zag,
  spiral,
  trochoidal,
  adaptive,  ///< none of these
};

/// On which side of the feed the nominal contour lies, as the spindle turns.
enum class Milling : std::uint8_t { undefined, climb, conventional, both };

/// How the tool came into the material.
struct Entry {
  enum class Kind : std::uint8_t { plunge, ramp, helix, outside, rapid };
  enum class Lead : std::uint8_t { none, line, arc };
  Kind kind = Kind::plunge;
  Lead lead = Lead::none;
  std::optional<double> pitch{};  ///< of a helix, mm a turn
  friend bool operator==(const Entry&, const Entry&) = default;
};

/// One way round: from a point back to it.
struct Loop {
  Span rows{};
  double perimeter = 0;
  double area = 0;  ///< positive counterclockwise
};

/// Where blocks come from, and what an edit of their contour would be.
struct Origin {
  enum class Kind : std::uint8_t {
    literal,
    once,
    shared,
    loop,
    expression,
    cycle_list,
    cycle_shape,
    mixed,
  };
  Kind kind = Kind::literal;
  std::optional<Span> lines{};        ///< of a loop
  std::optional<std::size_t> call{};  ///< place among the calls
  std::optional<Span> shape{};        ///< lines of P and Q of a turning cycle
};
enum class Editable : std::uint8_t { contour, shared, unroll, argument, no };

/// What one level of a feature has removed, by one operation or several. Contours in normal form.
struct Layer {
  double z = 0;
  double top = 0;
  std::vector<Span> cuts{};     ///< rows that move across at this level
  std::vector<Span> entries{};  ///< rows at feed that lead into it or out of it
  std::vector<Span> visits{};   ///< from the first rapid of the approach to the retract
  Frame frame{};
  double area = 0;            ///< of what was removed, mm²
  contour::Region removed{};  ///< V: sweep of the level, as far as there was material
  Contour contour{};          ///< outline of what was removed
  std::vector<Contour> islands{};
  Contour nominal{};  ///< what a drawing would say
  std::vector<Contour> nominal_islands{};
  std::vector<Loop> loops{};
  std::vector<std::uint32_t> links{};  ///< rows that are part of no loop
  Entry entry{};
  Origin origin{};

  [[nodiscard]] double volume() const { return area * (top - z); }
};

/// The share of one operation in a feature.
struct Cut {
  enum class Role : std::uint8_t { only, rough, finish, rest };
  std::size_t operation = 0;
  Role role = Role::only;
  std::vector<Span> visits{};
};

enum class RelationKind : std::uint8_t { nested, island, edge, crosses };
/// To another feature, by its place among the features.
struct Relation {
  std::size_t feature = 0;
  RelationKind kind = RelationKind::nested;
};

/// What the literal method says of a feature.
struct LiteralWord {
  enum class Type : std::uint8_t { pocket, side_milling, hole };
  Type type = Type::pocket;
  int kind = 0;  ///< of a pocket: 1 general, 2 round
};

enum class Reason : std::uint8_t {
  tool_assumed,
  stock_assumed,
  ring_by_default,
  methods_differ,
  adaptive,
  surface,
  no_material,
  entered_by_rapid,
  nose_not_compensated,
};

/// What only some types have.
struct FeatureMeasures {
  struct Round {
    double diameter = 0;
    Vec2 centre{};
  };
  std::optional<Round> round{};        ///< of a pocket that is a disc
  std::optional<double> width{};       ///< of a slot, chamfer, groove
  std::optional<double> length{};      ///< of a slot
  std::optional<int> open_ends{};      ///< of a slot
  std::optional<double> wall_share{};  ///< where part of the border is the stock's
  std::optional<double> draft_deg{};
  std::vector<Contour> strokes{};        ///< of an engraving, open
  std::optional<Contour> centre_line{};  ///< of a slot, a groove, an engraving; open
};

/// An element of a turned contour.
struct TurnedElement {
  enum class Kind : std::uint8_t { cylinder, shoulder, chamfer, taper, radius };
  Kind kind = Kind::cylinder;
  double z = 0;  ///< where it ends
  double x = 0;  ///< diameter there
  std::optional<double> radius{};
  std::optional<double> angle_deg{};
  Span rows{};
};

/// One roughing pass, at a diameter or at a Z.
struct TurnedPass {
  bool along_z = true;
  double at = 0;
  Span rows{};
};

/// What features of a lathe have. X are diameters.
struct TurnedPart {
  Contour contour{};  ///< open, (z, x/2)
  std::vector<TurnedElement> elements{};
  std::vector<TurnedPass> passes{};
  bool outer = true;
  double front = 0;
  double back = 0;
  std::optional<double> x{};
  std::optional<double> bottom{};    ///< diameter of a groove's, z of a face groove's
  std::optional<double> width{};     ///< of a groove
  std::optional<double> diameter{};  ///< of a bore on the axis
  std::vector<HoleStep> steps{};     ///< likewise
  struct Thread {
    double pitch = 0;
    double major = 0;  ///< diameters
    double minor = 0;
    double taper = 0;  ///< by how much the diameter changes from front to back, mm
    bool is_left_hand = false;
    int starts = 1;
  };
  std::optional<Thread> thread{};
  contour::Region removed{};  ///< (z, x/2)
};

/// A place that was machined: layers of one shape, one below the other.
struct Feature {
  FeatureType type = FeatureType::pocket;
  std::string key{};
  std::size_t setup = 0;
  std::uint32_t tool = 0;  ///< the first one
  std::optional<Relation> parent{};
  double top = 0;
  double bottom = 0;
  bool through = false;
  std::vector<Layer> layers{};
  std::vector<Cut> cuts{};
  Order order = Order::undefined;
  Strategy strategy = Strategy::single;
  std::optional<double> stepover{};
  std::optional<double> stepdown{};
  Milling milling = Milling::undefined;
  Entry entry{};
  Compensation compensated = Compensation::none;
  Origin origin{};
  Editable editable = Editable::contour;
  double confidence = 1;
  std::vector<Reason> reasons{};
  std::optional<LiteralWord> literal{};
  bool agree = true;
  FeatureMeasures measures{};
  std::optional<TurnedPart> turned{};
  double turned_volume = 0;  ///< of a lathe, mm³

  [[nodiscard]] double depth() const { return top - bottom; }
  [[nodiscard]] double volume() const;
};

}  // namespace kerf::features
