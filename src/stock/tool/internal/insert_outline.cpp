#include "stock/tool/internal/insert_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/decimal.hpp"
#include "math/math.hpp"
#include "stock/tool/insert_code.hpp"
#include "stock/tool/internal/angles.hpp"

namespace kerf::stock {
namespace {

using contour::Contour;
using contour::Vec2;
using contour::Vertex;
using M = Measure;

constexpr std::uint32_t kEdge = owner(InsertPart::edge);
constexpr std::uint32_t kBack = owner(InsertPart::back);

Vec2 towards(double degrees) {
  const auto [sine, cosine] = math::sine_cosine(radians(degrees));
  return {cosine, sine};
}
double cotangent_of_half(double degrees) { return 1 / math::tan(radians(degrees) / 2); }

/// A nose and the directions in which its edges leave it; the main one is farther counterclockwise.
struct Nose {
  double radius = 0;
  double main_deg = 0;
  double minor_deg = 0;
  Vec2 centre{};

  [[nodiscard]] double angle() const { return main_deg - minor_deg; }
  /// Where the edges would meet.
  [[nodiscard]] Vec2 corner() const {
    const double back = radius / math::sin(radians(angle()) / 2);
    return centre - back * towards((main_deg + minor_deg) / 2);
  }
};

Nose nose_at(double radius, double main_deg, double minor_deg, bool is_symmetric) {
  return {radius, main_deg, minor_deg, {is_symmetric ? 0 : radius, radius}};
}

/// From the main edge round to the minor one.
void append_nose(const Nose& nose, std::vector<Vertex>& vertices) {
  if (nose.radius == 0) return vertices.push_back({nose.corner(), 0, kEdge});
  const double bulge = math::tan(radians(180 - nose.angle()) / 4);
  vertices.push_back(
      {nose.centre + nose.radius * geometry::left_of(towards(nose.main_deg)), bulge, kEdge});
  vertices.push_back(
      {nose.centre - nose.radius * geometry::left_of(towards(nose.minor_deg)), 0, kEdge});
}

char letter_of(const Tool& tool) {
  const auto code = read_insert_code(tool.insert);
  return code ? code->shape : ' ';
}

/// Angles inside the corners of a body about a circle, from the nose on: they repeat.
struct Corners {
  double first;
  double second;
  int count;
  [[nodiscard]] double angle(int i) const { return i % 2 == 0 ? first : second; }
};

Corners corners_of(const Tool& tool) {
  constexpr std::string_view kRegular = "TSPHO";
  const char letter = letter_of(tool);
  const double tip = tool[M::tip_angle];
  if (tool.measures.get(M::tip_angle)) return {tip, 180 - tip, 4};
  if (letter == 'W') return {tip, 240 - tip, 6};
  if (kRegular.find(letter) == std::string_view::npos) return {tip, 180 - tip, 4};
  return {tip, tip, static_cast<int>(std::round(360 / (180 - tip)))};
}

double side(const Corners& corners, int i, double ic) {
  return ic / 2 * (cotangent_of_half(corners.angle(i)) + cotangent_of_half(corners.angle(i + 1)));
}

/// A circle; all but the quarter behind it cuts.
Insert round_insert(double radius, bool is_symmetric) {
  Insert insert{
      .outline = {}, .nose_radius = radius, .nose_centre = {is_symmetric ? 0 : radius, radius}};
  const double back_deg = is_symmetric ? 45 : 0;
  for (int i = 0; i < 4; ++i) {
    insert.outline.vertices.push_back({insert.nose_centre + radius * towards(back_deg + 90 * i),
                                       math::tan(std::numbers::pi / 8), i == 0 ? kBack : kEdge});
  }
  return insert;
}

double round_radius(const Tool& tool) {
  return tool.said(M::nose_radius).value_or(tool[M::ic] / 2);
}

Nose nose_of(const Tool& tool, bool is_symmetric) {
  const double tip = tool[M::tip_angle];
  const double main_deg = is_symmetric ? 90 + tip / 2 : 180 - tool[M::kapr];
  return nose_at(tool[M::nose_radius], main_deg, main_deg - tip, is_symmetric);
}

Nose thread_nose(const Tool& tool, bool is_symmetric) {
  const double half = tool[M::profile_angle] / 2;
  return nose_at(tool[M::nose_radius], 90 + half, 90 - half, is_symmetric);
}

/// Length of a flank, from where both would meet.
double thread_flank(const Tool& tool) {
  const auto pitch = tool.said(M::pitch);
  if (!pitch) return tool[M::ic] * std::sqrt(3.0);
  return *pitch / 2 / math::sin(radians(tool[M::profile_angle]) / 2);
}

std::string more_than_half(M measure, const Tool& tool, M whole) {
  return std::string(row_of(measure).name) + ", " + base::number_text(tool[measure]) +
         ", is more than half of " + std::string(row_of(whole).name) + ", " +
         base::number_text(tool[whole]);
}

}  // namespace

Insert nosed_insert(const Tool& tool, bool is_symmetric) {
  if (letter_of(tool) == 'R') return round_insert(round_radius(tool), is_symmetric);
  const Nose nose = nose_of(tool, is_symmetric);
  const Corners corners = corners_of(tool);
  std::vector<Vertex> vertices;
  append_nose(nose, vertices);
  Vec2 corner = nose.corner();
  double heading = nose.minor_deg;
  for (int i = 0; i + 1 < corners.count; ++i) {
    corner = corner + side(corners, i, tool[M::ic]) * towards(heading);
    heading += 180 - corners.angle(i + 1);
    // The last side leads back to the nose.
    vertices.push_back({corner, 0, i + 2 == corners.count ? kEdge : kBack});
  }
  return {.outline = {std::move(vertices)}, .nose_radius = nose.radius, .nose_centre = nose.centre};
}

Insert blade(const Tool& tool, bool is_symmetric) {
  const double c = tool[M::corner_radius];
  const double left = is_symmetric ? -tool[M::width] / 2 : 0;
  const double right = left + tool[M::width];
  const double top = tool.said(M::stickout).value_or(Insert::kEndless_mm);
  const double edge = std::min(tool.said(M::flute_length).value_or(top), top);
  const double bulge = math::tan(std::numbers::pi / 8);
  std::vector<Vertex> vertices;
  const auto add = [&](double u, double v, double bulge_of, std::uint32_t part) {
    const Vec2 point{u, v};
    if (!vertices.empty() && vertices.back().point == point) vertices.pop_back();
    vertices.push_back({point, bulge_of, part});
  };
  add(left, c, bulge, kEdge);
  add(left + c, 0, 0, kEdge);
  add(right - c, 0, bulge, kEdge);
  add(right, c, 0, kEdge);
  add(right, edge, 0, kBack);
  add(right, top, 0, kBack);
  add(left, top, 0, edge < top ? kBack : kEdge);
  if (edge < top) add(left, edge, 0, kEdge);
  return {
      .outline = {std::move(vertices)}, .nose_radius = c, .nose_centre = {is_symmetric ? 0 : c, c}};
}

Insert thread_point(const Tool& tool, bool is_symmetric) {
  const Nose nose = thread_nose(tool, is_symmetric);
  std::vector<Vertex> vertices;
  append_nose(nose, vertices);
  vertices.push_back({nose.corner() + thread_flank(tool) * towards(nose.minor_deg), 0, kBack});
  vertices.push_back({nose.corner() + thread_flank(tool) * towards(nose.main_deg), 0, kEdge});
  return {.outline = {std::move(vertices)}, .nose_radius = nose.radius, .nose_centre = nose.centre};
}

Contour rectangle(Vec2 low, Vec2 high, InsertPart part) {
  const std::uint32_t by = owner(part);
  return {{{low, 0, by}, {{high.u, low.v}, 0, by}, {high, 0, by}, {{low.u, high.v}, 0, by}}};
}

std::string objection_to_outline(const Tool& tool) {
  if (tool.kind == ToolKind::threading) {
    const Nose nose = thread_nose(tool, true);
    const double tangent = nose.radius * cotangent_of_half(nose.angle());
    if (tangent < thread_flank(tool)) return {};
    return "nose_radius, " + base::number_text(nose.radius) + ", is larger than the thread";
  }
  if (tool.value(M::width)) {
    if (2 * tool[M::corner_radius] <= tool[M::width]) return {};
    return more_than_half(M::corner_radius, tool, M::width);
  }
  if (letter_of(tool) == 'R') return round_radius(tool) > 0 ? "" : "a round insert has a radius";
  if (2 * tool[M::nose_radius] > tool[M::ic]) return more_than_half(M::nose_radius, tool, M::ic);
  return {};
}

}  // namespace kerf::stock
