#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drawing/dxf/internal/kinds.hpp"
#include "drawing/dxf/internal/sweep.hpp"
#include "drawing/pen.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr int kRadius = 40;

bool has_radius(Subject& subject) {
  if (subject.record().has(kRadius)) return true;
  subject.refuse("has no radius (group 40)");
  return false;
}

Ellipse circle_of(const Record& record) {
  const double radius = std::abs(record.number(kRadius));
  return {record.point(10), {radius, 0}, {0, radius}};
}

Pen pen_of(Subject& subject) { return {subject.canvas(), subject.entity(), subject.to_mm()}; }

bool is_off(const Record& record, int code, double height) {
  return record.has(code) && std::abs(record.number(code) - height) > kSameHeight;
}

bool is_level(const Record& record, std::span<const int> codes) {
  const double first = record.number(codes.front());
  return std::none_of(codes.begin(), codes.end(),
                      [&](int code) { return is_off(record, code, first); });
}

}  // namespace

void draw_line(Subject& subject) {
  const Record& record = subject.record();
  Pen pen = pen_of(subject);
  pen.begin(record.point(10));
  pen.line_to(record.point(11));
  constexpr std::array kHeights{30, 31};
  if (!is_level(record, kHeights)) subject.tell_heights();
}

void draw_point(Subject& subject) {
  const EntityId entity = subject.entity();
  subject.canvas().add(Point{subject.to_mm()(subject.record().point(10)), entity});
}

void draw_circle(Subject& subject) {
  if (has_radius(subject)) pen_of(subject).whole(circle_of(subject.record()));
}

void draw_arc(Subject& subject) {
  if (!has_radius(subject)) return;
  const Record& record = subject.record();
  const Sweep sweep = sweep_of_degrees(record.number(50), record.number(51));
  Pen pen = pen_of(subject);
  pen.ellipse(circle_of(record), sweep.from_rad, sweep.by_rad);
  if (sweep.is_whole()) pen.close();
}

void draw_ellipse(Subject& subject) {
  const Record& record = subject.record();
  if (!record.has(11) || !record.has(kRadius))
    return subject.refuse("has no axis (group 11) or no ratio (group 40)");
  const double side = facing_of(record) == Facing::down ? -1 : 1;
  const Vec2 major = record.point(11);
  const Vec2 minor = side * record.number(kRadius) * geometry::left_of(major);
  const Sweep sweep = sweep_of(record.number(41), record.number(42, 2 * std::numbers::pi));
  Pen pen = pen_of(subject);
  pen.ellipse({record.point(10), major, minor}, sweep.from_rad, sweep.by_rad);
  if (sweep.is_whole()) pen.close();
}

// Its third and fourth corners stand crosswise; of a triangle they are the same.
void draw_solid(Subject& subject) {
  const Record& record = subject.record();
  Pen pen = pen_of(subject);
  pen.begin(record.point(10));
  pen.line_to(record.point(11));
  if (record.has(13) && record.point(13) != record.point(12)) pen.line_to(record.point(13));
  pen.line_to(record.point(12));
  pen.close();
}

void draw_face(Subject& subject) {
  const Record& record = subject.record();
  const int corners = record.has(13) && record.point(13) != record.point(12) ? 4 : 3;
  const int hidden = record.integer(70);
  constexpr std::array kHeights{30, 31, 32, 33};
  if (!is_level(record, kHeights)) subject.tell_heights();
  Pen pen = pen_of(subject);
  bool is_drawn = false;  // the edge before
  for (int i = 0; i < corners; ++i) {
    const bool is_hidden = ((static_cast<unsigned>(hidden) >> static_cast<unsigned>(i)) & 1U) != 0;
    if (!is_drawn && !is_hidden) pen.begin(record.point(10 + i));
    const bool goes_round = i + 1 == corners && (hidden & 15) == 0;
    if (goes_round) return pen.close();
    if (!is_hidden) pen.line_to(record.point(10 + (i + 1) % corners));
    is_drawn = !is_hidden;
  }
}

}  // namespace kerf::drawing::dxf
