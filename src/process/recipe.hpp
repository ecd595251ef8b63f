#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/place.hpp"
#include "geometry/vec2.hpp"

namespace kerf::process {

using geometry::Vec2;

/// What is done along or within contours.
enum class Process : std::uint8_t { engrave, mark, cut, fill, raster, weld, heat, drill };

/// How the power of the beam goes with the speed: M3, M4.
enum class Beam : std::uint8_t { constant, follow };
enum class PassOrder : std::uint8_t { contour, operation };
enum class StartAt : std::uint8_t { automatic, first, corner };
enum class Overlaps : std::uint8_t { keep, once };
enum class Air : std::uint8_t { off, mist, flood };
enum class CutSide : std::uint8_t { automatic, outside, inside, on };
enum class CutCorner : std::uint8_t { round, sharp };
enum class FillKind : std::uint8_t { lines, offset };
enum class Dither : std::uint8_t {
  threshold,
  ordered_2,
  ordered_4,
  ordered_8,
  floyd_steinberg,
  jarvis,
  stucki,
  grey
};

/// The way into a contour or out of it.
struct Lead {
  enum class Kind : std::uint8_t { none, line, arc };
  Kind kind = Kind::none;
  double length_mm = 0;   ///< of a line
  double radius_mm = 0;   ///< of an arc
  double angle_deg = 90;  ///< of a line to the tangent; of an arc, how far it turns
};

struct Tabs {
  std::optional<std::uint32_t> count;
  std::optional<double> spacing_mm;
  double width_mm = 0;
  double power_percent = 0;

  [[nodiscard]] bool are_asked_for() const { return count || spacing_mm; }
};

struct Weave {
  enum class Shape : std::uint8_t { none, zigzag, sine, circle };
  Shape shape = Shape::none;
  double width_mm = 0;
  double pitch_mm = 0;
};

/// One operation of the job: what is done with some layers. What the job leaves out, a material or
/// the machine fills (materials.hpp); what is empty then, has the default of its process.
/// Units: mm, mm/min, percent, ms where the name says so, seconds.
struct Operation {
  std::string name;
  std::vector<std::string> layers;  ///< names with * and ?, "#ff0000", "aci:1", "class:cut", "*"
  Process process = Process::engrave;
  bool enabled = true;
  std::uint32_t line = 0;  ///< in the job file; 0: made without one
  base::Place place;       ///< the same, for findings

  std::optional<double> power_percent;
  std::optional<double> ton_ms;
  std::optional<double> toff_ms;
  std::optional<double> frequency_hz;
  std::optional<double> feed;  ///< mm/min
  std::optional<double> ms_per_mm;
  std::optional<Beam> beam;
  std::uint32_t passes = 1;
  bool has_passes = false;  ///< they are said
  double z_step = 0;
  std::optional<double> z;
  PassOrder pass_order = PassOrder::contour;
  Air air = Air::off;
  std::string gas;
  StartAt start = StartAt::automatic;
  bool dashes = false;
  Overlaps overlaps = Overlaps::keep;
  std::optional<double> min_power_percent;

  // Of a mill
  std::optional<double> depth;
  std::optional<double> step_down;
  std::optional<double> safe_z;
  std::optional<double> plunge;  ///< mm/min
  std::optional<std::uint32_t> tool;
  std::optional<double> spindle;  ///< rpm

  // cut
  std::optional<double> overcut;  ///< also of engrave
  std::optional<double> kerf;
  CutSide side = CutSide::automatic;
  CutCorner corner = CutCorner::round;
  Lead lead_in;
  Lead lead_out;
  bool lead_open = false;
  double pierce_s = 0;
  bool has_pierce = false;  ///< it is said
  std::optional<double> pierce_power_percent;
  Tabs tabs;

  // fill, raster, heat
  std::optional<double> spacing;  ///< fill
  double angle_deg = 0;
  bool cross = false;
  FillKind fill_kind = FillKind::lines;
  double inset = 0;
  bool bidirectional = true;
  std::optional<double> overscan;  ///< empty: as long as the axes need
  bool outline = false;

  // raster
  std::optional<double> interval;
  std::optional<double> pixel;
  Dither mode = Dither::floyd_steinberg;
  std::uint32_t level = 128;
  std::vector<std::pair<double, double>> scan_offset;  ///< (feed, mm)
  std::vector<std::pair<double, double>> curve{{0, 0}, {1, 1}};
  bool invert = false;
  double gamma = 1;
  double brightness = 0;  ///< -100 to 100
  double contrast = 0;    ///< likewise
  bool mirror = false;

  // weld
  double ramp_in = 0;
  double ramp_out = 0;
  double close = 2;
  Weave weave;  ///< also of heat

  // heat
  std::optional<double> track_width;
  double overlap = 0.2;

  // drill
  double max_diameter = 2;
  std::optional<std::uint32_t> pulses;
  std::optional<double> dwell_s;
  bool trepan = false;
};

enum class Mirror : std::uint8_t { none, x, y };
enum class Anchor : std::uint8_t {
  origin,
  lower_left,
  lower_centre,
  lower_right,
  centre_left,
  centre,
  centre_right,
  upper_left,
  upper_centre,
  upper_right
};

/// Where the drawing lies on the machine; done in this order.
struct PlaceWords {
  std::array<double, 2> scale{1, 1};
  std::optional<std::array<double, 2>> fit;
  Mirror mirror = Mirror::none;
  double rotate_deg = 0;
  Anchor anchor = Anchor::origin;
  Vec2 at{};
};

struct Array {
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
  double dx = 0;
  double dy = 0;
  std::uint32_t count = 0;  ///< of a ring; 0: columns and rows
  double angle_deg = 0;     ///< from copy to copy
  Vec2 centre{};
  bool is_mixed = false;  ///< order = "travel"

  [[nodiscard]] std::size_t copies() const {
    return count > 0 ? count : std::size_t{columns} * rows;
  }
};

/// Where the tool stands at the end.
enum class EndKind : std::uint8_t { origin, stay, point };
struct End {
  EndKind kind = EndKind::origin;
  Vec2 at{};
};

struct TextLine {
  std::string words;
  Vec2 at{};
  double rotate_deg = 0;
  std::string layer = "text";
  std::optional<double> height;
};

struct TextWords {
  bool is_said = false;  ///< the job has [text]: texts of drawings are drawn
  std::string font = "kerf-line";
  std::optional<double> height;
  double spacing = 1;
  std::string align = "left";
  std::vector<TextLine> lines;
  std::optional<std::uint32_t> serial_start;
  std::uint32_t serial_step = 1;
  std::uint32_t serial_width = 0;
  std::string serial_keep;  ///< a file; empty: none
};

struct ImageWords {
  std::optional<double> width;
  std::optional<double> height;
  std::optional<double> dpi;
};

/// The surface that the drawing lies on (a five-axis head).
struct Wrap {
  enum class Shape : std::uint8_t { none, cylinder, cone, sphere };
  Shape shape = Shape::none;
  char axis = 'X';
  double radius = 0;
  std::array<double, 3> centre{};
  double half_angle_deg = 0;
  double at = 0;
  double clearance = 5;
  double normal_deg = 0.5;
};

/// What is done with drawings, as a value: a job file (docs/drawings.md), or the words of a command
/// line. `Job` is another thing: a run.
struct Recipe {
  std::string source;  ///< name of the file; empty: none
  std::string machine;
  std::string material;
  base::Place material_place;  ///< where the job file says it
  double tolerance = 0.01;
  double join = 0.02;
  double same = 0.005;
  bool by_travel = true;  ///< order; else as drawn
  End end;
  std::string lens_side;  ///< L or R; empty: as traced
  PlaceWords place;
  Array array;
  TextWords text;
  ImageWords image;
  Wrap wrap;
  std::vector<Operation> operations;
};

}  // namespace kerf::process
