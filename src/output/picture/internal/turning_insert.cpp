#include "output/picture/internal/turning_insert.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"

namespace kerf::output::plot {
namespace {

using geometry::Vec2;
using Kind = TurningInsert::Kind;

// (z, x) from the nose to the tip, by the direction's number.
constexpr std::array<Vec2, 10> kDirections = {
    {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}};
constexpr double kLead_deg = 85;  // the leading edge from Z: behind it the tool clears a wall

Vec2 heading(double angle_deg) {
  const auto [sine, cosine] = geometry::sine_cosine_deg(angle_deg);
  return {cosine, sine};
}

bool reaches_axis(const ToolWay& way) {
  return std::abs(way.last[kX]) < 1e-6 || (way.first[kX] > 0) != (way.last[kX] > 0);
}

Kind kind_of(const TurningTool& tool, const ToolWay& way, bool threads, double middle_mm) {
  if (threads) return Kind::thread;
  if (tool.driven) return Kind::driven;
  if (way.on_axis) return Kind::drill;
  const bool faces = reaches_axis(way) && !way.plunges.empty() && way.plunges.front() > middle_mm;
  return way.only_plunges() && !faces ? Kind::blade : Kind::rhomb;
}

// The widest insert whose flank clears the steepest way down.
double corner_for(double steepest_deg) {
  for (const double corner_deg : {80.0, 55.0}) {
    if (kLead_deg - corner_deg >= steepest_deg) return corner_deg;
  }
  return 35;
}

// At least 3 mm, and as wide as the steps of a groove that is cut beside itself.
double blade_width(const std::vector<double>& plunges) {
  constexpr double kNarrow = 3, kWidest = 6;
  double width = kNarrow;
  for (std::size_t i = 1; i < plunges.size(); ++i) {
    const double step = plunges[i] - plunges[i - 1];
    if (step <= kWidest) width = std::max(width, step);
  }
  return width;
}

void turn_tip(TurningInsert& insert, int number) {
  insert.tip_number = number;
  insert.tip_known = number >= 1 && number <= 8;
  insert.tip = insert.tip_known ? kDirections[static_cast<std::size_t>(number)]
               : insert.inside  ? Vec2{-1, 1}
                                : Vec2{-1, -1};
}

// Two edges from the rounded corner, closed to a rhomb. `first` and `second` are the angles of the
// edges from the corner, counterclockwise.
std::vector<Vec2> rhomb(Vec2 nose, double nose_mm, double first_deg, double second_deg,
                        double edge_mm) {
  constexpr int kChords = 12;
  const double begin_deg = second_deg + 90, sweep_deg = first_deg - 90 + 360 - begin_deg;
  std::vector<Vec2> points;
  for (int n = 0; n <= (nose_mm > 0 ? kChords : 0); ++n)
    points.push_back(nose + nose_mm * heading(begin_deg + sweep_deg * n / kChords));
  const Vec2 along_first = edge_mm * heading(first_deg);
  const Vec2 along_second = edge_mm * heading(second_deg);
  points.push_back(points.back() + along_first);
  points.push_back(points.back() + along_second);
  points.push_back(points.front() + along_second);
  return points;
}

std::vector<Vec2> drill(double radius, double edge_mm) {
  constexpr double kPoint = 0.6009;  // length of a point of 118° by its radius
  const double back = std::max(2.5 * edge_mm, 3 * radius);
  return {{0, 0},
          {kPoint * radius, -radius},
          {back, -radius},
          {back, radius},
          {kPoint * radius, radius}};
}

std::vector<Vec2> mirrored(std::vector<Vec2> points, double z, double x) {
  for (Vec2& point : points) point = {point.u * z, point.v * x};
  return points;
}

std::string number(double value) { return base::rounded_text(value, 3); }

}  // namespace

// Of a tip that looks to -z and -x the body lies at +z and +x; the others are its mirror images.
std::vector<Vec2> TurningInsert::outline(double edge_mm) const {
  const double x = tip.v > 0 ? -1 : 1, z = tip.u > 0 ? -1 : 1;
  const Vec2 own{nose().u * z, nose().v * x};
  switch (kind) {
    case Kind::rhomb: {
      const bool corner = tip.u != 0 && tip.v != 0;
      const double middle = tip.v == 0 ? 0 : 90;
      const double second = corner ? kLead_deg : middle + corner_deg / 2;
      return mirrored(rhomb(own, nose_mm, second - corner_deg, second, edge_mm), z, x);
    }
    case Kind::thread:
      return mirrored({{0, 0}, 0.8 * edge_mm * heading(60), 0.8 * edge_mm * heading(120)}, z, x);
    case Kind::blade: {
      const double l = left_mm(), r = l + width_mm, h = std::max(1.4 * edge_mm, 2 * width_mm);
      return mirrored({{l, 0}, {r, 0}, {r, h}, {l, h}}, 1, x);
    }
    case Kind::drill: return drill(width_mm > 0 ? width_mm / 2 : edge_mm / 4, edge_mm);
    case Kind::driven: return drill(width_mm > 0 ? width_mm / 2 : edge_mm / 4, 0.6 * edge_mm);
  }
  return {};
}

std::string TurningInsert::words() const {
  const std::string nose = nose_mm > 0 ? ", R " + number(nose_mm) : std::string();
  const std::string which = tip_known ? ", tip " + std::to_string(tip_number) : std::string();
  const std::string size = width_mm > 0 ? " \u2300 " + number(width_mm) : std::string();
  switch (kind) {
    case Kind::rhomb:
      return number(corner_deg) + (inside ? "\u00b0 boring insert" : "\u00b0 insert") + nose +
             which;
    case Kind::thread: return "60\u00b0";
    case Kind::blade: return "blade " + number(width_mm) + " mm" + which;
    case Kind::drill: return "drill" + size;
    case Kind::driven: return "driven" + size;
  }
  return {};
}

TurningInsert insert_of(const TurningTool& tool, const ToolWay& way, bool threads,
                        double middle_mm) {
  TurningInsert insert;
  insert.kind = kind_of(tool, way, threads, middle_mm);
  insert.inside = way.inside();
  turn_tip(insert, tool.nose.tip);
  if (insert.tip_known && insert.tip.v != 0) insert.inside = insert.tip.v > 0;
  insert.nose_mm = std::abs(tool.nose.radius_mm);
  insert.corner_deg = corner_for(way.steepest_deg);
  const bool drills = insert.kind == Kind::drill || insert.kind == Kind::driven;
  insert.width_mm = drills ? 2 * tool.radius : blade_width(way.plunges);
  return insert;
}

}  // namespace kerf::output::plot
