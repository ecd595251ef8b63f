#include "output/part/internal/solid_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "math/math.hpp"
#include "output/part/internal/sheet_parts.hpp"
#include "output/picture/solid/renderer.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kMargin = 56;
constexpr double kPixelsPerUnit = 1.5;
constexpr double kArrow = 36;
constexpr Color kThreadInk{52, 58, 66};
/// Surfaces between points of dexels are chords: pixels.
constexpr double kThreadSlack = 5;
constexpr double kPointsATurn = 48;
constexpr double kMostTurns = 2000;

Body body_of(const stock::surface::Surface& surface, const Paints& paints) {
  Body body{&surface.mesh, {}};
  body.paints.reserve(surface.owners.size());
  std::uint32_t last = 0;
  std::uint16_t paint = Paints::kStock;
  for (const std::uint32_t owner : surface.owners) {
    if (owner != last) paint = paints.of_motion(owner);
    last = owner;
    body.paints.push_back(paint);
  }
  return body;
}

/// On the wall of the hole, or round the bolt.
std::vector<Vec3> helix_of(const StockFacts::Thread& thread) {
  const Vec3 way = thread.end - thread.begin;
  const double size = length(way);
  if (!(size > 0) || !(thread.pitch > 0)) return {};
  const Vec3 along = (1 / size) * way;
  const Vec3 u = unit(cross(along, std::fabs(along.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(along, u);
  const double radius = (thread.is_inside ? thread.minor : thread.major) / 2;
  // Seen along the way a right-handed one turns clockwise.
  const double sense = thread.hand == stock::Hand::right ? 1 : -1;
  const double turns = std::min(size / thread.pitch, kMostTurns);
  const double count = std::ceil(turns * kPointsATurn);
  std::vector<Vec3> points;
  for (double i = 0; i <= count; ++i) {
    const auto [sine, cosine] = math::sine_cosine(sense * 2 * std::numbers::pi * turns * i / count);
    points.push_back(thread.begin + (i / count) * way + radius * (cosine * u + sine * v));
  }
  return points;
}

void arrow(DisplayList& sheet, Point from, Point to, const char* name, Color color) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double size = std::sqrt(dx * dx + dy * dy);
  if (size < 3) {  // along the view
    Outline dot;
    dot.circle(from, 3.2);
    sheet.add(std::move(dot), {color, 1.6, false, kWhite});
    return;
  }
  const double ux = dx / size, uy = dy / size;
  Outline line;
  line.segment(from, {to.x - 6 * ux, to.y - 6 * uy});
  sheet.add(std::move(line), {color, 2.2, false, {}});
  Outline head;
  head.move_to(to);
  head.line_to({to.x - 9 * ux - 3.6 * uy, to.y - 9 * uy + 3.6 * ux});
  head.line_to({to.x - 9 * ux + 3.6 * uy, to.y - 9 * uy - 3.6 * ux});
  head.close();
  sheet.add(std::move(head), {{}, 1, false, color});
  sheet.add(
      Text{{to.x + 9 * ux, to.y + 9 * uy + 4.5}, name, 13, Anchor::middle, color, true, true});
}

}  // namespace

SolidView::SolidView(const PartScene& scene, const Paints& paints, const Camera& camera)
    : scene_(scene), camera_(camera) {
  solids_.paints = paints.colors();
  solids_.bodies.push_back(body_of(scene.part, paints));
  for (const stock::surface::Surface& fixture : scene.fixtures) {
    solids_.bodies.push_back({&fixture.mesh, std::vector<std::uint16_t>(
                                                 fixture.mesh.triangles.size(), Paints::kFixture)});
  }
}

double SolidView::height_for(double width) const {
  const Point size = seen_size(solids_, camera_);
  if (!(size.x > 0)) return width;
  return (width - 2 * kMargin) * size.y / size.x + 2 * kMargin;
}

void SolidView::draw(DisplayList& sheet, const Rect& frame) const {
  const Projector projector(solids_, camera_, frame.width, frame.height, kMargin);
  const auto width = static_cast<int>(std::round(kPixelsPerUnit * frame.width));
  const auto height = static_cast<int>(std::round(kPixelsPerUnit * frame.height));
  const Projector pixels = projector.scaled(kPixelsPerUnit);
  Rendering rendering = render(solids_, pixels, width, height, scene_.jobs);
  std::vector<PlacedMark> marks;
  const double slack = 4 / projector.pixels_per_mm();
  for (const Mark& mark : marks_of(scene_)) {
    const Vec3 at = mark.told->finding.at;
    const Point place = projector.map(at);
    const bool hidden = rendering.hides(pixels.map(at), pixels.depth(at), slack);
    marks.push_back({mark, {frame.left + place.x, frame.top + place.y}, hidden});
  }
  rendering.image.at = frame;
  sheet.add(plot::Image(rendering.image));
  draw_threads(sheet, frame, rendering, projector);
  Outline border;
  border.rectangle(frame);
  sheet.add(std::move(border), {kGrid, 1, false, {}});
  draw_axes(sheet, {frame.left + 60, frame.bottom() - 56});
  draw_scale_bar(sheet, {frame.right() - 24, frame.bottom() - 20}, projector.pixels_per_mm());
  draw_marks(sheet, marks, frame);
}

/// Of threads whose groove is not in the part a helix on its face, where that is seen.
void SolidView::draw_threads(DisplayList& sheet, const Rect& frame, const Rendering& rendering,
                             const Projector& projector) const {
  const Projector pixels = projector.scaled(kPixelsPerUnit);
  const double slack = kThreadSlack / projector.pixels_per_mm();
  Outline lines;
  for (const StockFacts::Thread& thread : scene_.facts->threads) {
    if (thread.is_milled) continue;
    std::optional<Point> last;
    for (const Vec3& at : helix_of(thread)) {
      const Point place = projector.map(at);
      const bool is_there = !scene_.is_opened || at.x <= 0 || at.y <= 0;
      const bool is_seen = is_there && !rendering.hides(pixels.map(at), pixels.depth(at), slack);
      const Point here{frame.left + place.x, frame.top + place.y};
      if (is_seen && last) lines.segment(*last, here);
      last = is_seen ? std::optional(here) : std::nullopt;
    }
  }
  sheet.add(std::move(lines), {kThreadInk, 0.7, false, {}});
}

/// The ones that point away first.
void SolidView::draw_axes(DisplayList& sheet, Point origin) const {
  struct Axis {
    Vec3 along;
    const char* name;
    Color color;
  };
  std::array<Axis, 3> axes{{{{1, 0, 0}, "X", {200, 45, 45}},
                            {{0, 1, 0}, "Y", {40, 140, 60}},
                            {{0, 0, 1}, "Z", {45, 85, 190}}}};
  std::stable_sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) {
    return dot(a.along, camera_.toward) < dot(b.along, camera_.toward);
  });
  for (const Axis& axis : axes) {
    const Point to{origin.x + kArrow * dot(axis.along, camera_.right),
                   origin.y - kArrow * dot(axis.along, camera_.up)};
    arrow(sheet, origin, to, axis.name, axis.color);
  }
}

}  // namespace kerf::output::plot
