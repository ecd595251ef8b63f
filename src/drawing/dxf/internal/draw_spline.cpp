#include <cmath>

#include "drawing/dxf/internal/kinds.hpp"
#include "drawing/dxf/internal/sweep.hpp"
#include "drawing/spline.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr int kClosed = 1;

/// The groups of a SPLINE, sorted out.
struct SplineGroups {
  Spline spline;
  Through through;
  std::vector<double> weights;
  bool is_level = true;

  void take(const Group& group);
  void take_height(double z) { is_level = is_level && std::abs(z - first_height) <= kSameHeight; }
  double first_height = 0;
};

void SplineGroups::take(const Group& group) {
  std::vector<Weighted>& controls = spline.points;
  std::vector<Vec2>& fits = through.points;
  switch (group.code) {
    case 40: return spline.knots.push_back(group.number);
    case 41: return weights.push_back(group.number);
    case 10: return controls.push_back({{group.number, 0}});
    case 20:
      if (!controls.empty()) controls.back().at.v = group.number;
      return;
    case 11: return fits.push_back({group.number, 0});
    case 21:
      if (!fits.empty()) fits.back().v = group.number;
      return;
    case 30:
    case 31: return take_height(group.number);
    default: return;
  }
}

std::optional<Vec2> direction_of(const Record& record, int code) {
  const Vec2 direction = record.point(code);
  return geometry::length(direction) > 0 ? std::optional(direction) : std::nullopt;
}

SplineGroups groups_of(const Record& record) {
  SplineGroups groups;
  groups.first_height = record.number(30, record.number(31));
  for (const Group& group : record.groups()) groups.take(group);
  groups.spline.degree = record.integer(71, 3);
  groups.through.begins = direction_of(record, 12);
  groups.through.ends = direction_of(record, 13);
  groups.through.is_closed = record.flag(70, kClosed);
  return groups;
}

void draw_controlled(SplineGroups& groups, Subject& subject) {
  Spline& spline = groups.spline;
  if (!groups.weights.empty() && groups.weights.size() != spline.points.size())
    return subject.refuse("has not as many weights as control points");
  for (std::size_t i = 0; i < groups.weights.size(); ++i)
    spline.points[i].weight = groups.weights[i];
  if (const std::string fault = fault_of(spline); !fault.empty()) return subject.refuse(fault);
  Pen pen(subject.canvas(), subject.entity(), subject.to_mm());
  const Vec2 begin = begin_of(spline);
  pen.begin(begin);
  draw(spline, pen);
  const double way = geometry::length(subject.to_mm().direction(pen.at() - begin));
  if (subject.record().flag(70, kClosed) && way <= subject.canvas().reading().same_mm) pen.close();
}

void draw_through(Through& through, Subject& subject) {
  take_out_twins(through);
  if (through.points.size() < 3) through.is_closed = false;
  if (through.points.size() < 2) return subject.refuse("has fewer than two points");
  Pen pen(subject.canvas(), subject.entity(), subject.to_mm());
  pen.begin(through.points.front());
  draw(through, pen);
  if (through.is_closed) pen.close();
}

}  // namespace

void draw_spline(Subject& subject) {
  SplineGroups groups = groups_of(subject.record());
  if (!groups.is_level) subject.tell_heights();
  if (groups.spline.points.empty()) return draw_through(groups.through, subject);
  draw_controlled(groups, subject);
}

}  // namespace kerf::drawing::dxf
