#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "drawing/dxf/internal/bulges.hpp"
#include "drawing/dxf/internal/kinds.hpp"
#include "drawing/dxf/internal/sweep.hpp"
#include "drawing/spline.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr int kPaths = 91;
constexpr int kPath = 92;
constexpr int kEdge = 72;

/// The groups of a path or an edge in their order.
class Groups {
 public:
  explicit Groups(std::span<const Group> groups) : groups_(groups) {}

  [[nodiscard]] double number(int code, double otherwise = 0) const {
    for (const Group& group : groups_)
      if (group.code == code) return group.number;
    return otherwise;
  }
  [[nodiscard]] Vec2 point(int code) const { return {number(code), number(code + 10)}; }
  [[nodiscard]] int integer(int code, int otherwise = 0) const {
    return integer_of(number(code, otherwise));
  }
  [[nodiscard]] std::span<const Group> all() const { return groups_; }

 private:
  std::span<const Group> groups_;
};

/// From the group `begin` on, each beginning with a group `code`.
std::vector<Groups> parted(std::span<const Group> groups, int code) {
  std::vector<Groups> parts;
  std::size_t begin = groups.size();
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].code != code) continue;
    if (begin < i) parts.emplace_back(groups.subspan(begin, i - begin));
    begin = i;
  }
  if (begin < groups.size()) parts.emplace_back(groups.subspan(begin));
  return parts;
}

bool ends_paths(const Group& group) { return group.code == 75 || group.code == 98; }

/// What follows the paths is its pattern, and points from which it is filled.
std::span<const Group> paths_of(const Record& record) {
  const std::span<const Group> groups = record.from(kPaths);
  return {groups.begin(), std::find_if(groups.begin(), groups.end(), ends_paths)};
}

void draw_outline(const Groups& path, Pen& pen) {
  std::vector<BulgeVertex> vertices;
  for (const Group& group : path.all()) {
    if (group.code == 10)
      vertices.push_back({{group.number, 0}});
    else if (vertices.empty())
      continue;
    else if (group.code == 20)
      vertices.back().at.v = group.number;
    else if (group.code == 42)
      vertices.back().bulge = group.number;
  }
  const bool is_closed = path.number(73, 1) != 0;
  draw_bulges(vertices, is_closed, pen);
}

/// Edges one after the other. Where one does not begin at the end of the one before, another path
/// begins; where all do, the path is closed.
class EdgePath {
 public:
  EdgePath(Subject& subject, Pen& pen) : subject_(subject), pen_(pen) {}

  void draw(const Groups& edge);
  void end();

 private:
  void draw_line(const Groups& edge);
  void draw_arc(const Groups& edge);
  void draw_ellipse(const Groups& edge);
  void draw_spline(const Groups& edge);
  void go_to(Vec2 begin);
  [[nodiscard]] bool is_same(Vec2 a, Vec2 b) const;

  Subject& subject_;
  Pen& pen_;
  Vec2 first_;
};

bool EdgePath::is_same(Vec2 a, Vec2 b) const {
  const double way = geometry::length(subject_.to_mm().direction(a - b));
  return way <= subject_.canvas().reading().same_mm;
}

void EdgePath::go_to(Vec2 begin) {
  if (pen_.has_begun() && is_same(pen_.at(), begin)) return;
  end();
  pen_.begin(begin);
  first_ = begin;
}

void EdgePath::end() {
  if (!pen_.has_begun()) return;
  if (is_same(pen_.at(), first_))
    pen_.close();
  else
    pen_.end();
}

void EdgePath::draw(const Groups& edge) {
  switch (edge.integer(kEdge)) {
    case 1: return draw_line(edge);
    case 2: return draw_arc(edge);
    case 3: return draw_ellipse(edge);
    case 4: return draw_spline(edge);
    default: return subject_.refuse("has an edge of a kind that is none (group 72)");
  }
}

void EdgePath::draw_line(const Groups& edge) {
  go_to(edge.point(10));
  pen_.line_to(edge.point(11));
}

// Angles of a clockwise edge count clockwise.
void EdgePath::draw_arc(const Groups& edge) {
  const double way = edge.number(73, 1) != 0 ? 1 : -1;
  const double radius = std::abs(edge.number(40));
  const Sweep sweep = sweep_of_degrees(edge.number(50), edge.number(51));
  const Ellipse circle{edge.point(10), {radius, 0}, {0, way * radius}};
  const auto at = [&](double angle) {
    return circle.centre + math::cos(angle) * circle.first + math::sin(angle) * circle.second;
  };
  go_to(at(sweep.from_rad));
  if (sweep.is_whole()) return pen_.ellipse(circle, sweep.from_rad, sweep.by_rad);
  pen_.bulge_to(at(sweep.from_rad + sweep.by_rad), way * math::tan(0.25 * sweep.by_rad));
}

// Its angles are those of the points, not the parameter's.
void EdgePath::draw_ellipse(const Groups& edge) {
  constexpr double kRadian = std::numbers::pi / 180;
  const double way = edge.number(73, 1) != 0 ? 1 : -1;
  const double ratio = edge.number(40, 1);
  const Vec2 major = edge.point(11);
  const auto parameter = [&](double angle_deg) {
    const double angle = kRadian * angle_deg;
    return math::atan2(math::sin(angle), ratio * math::cos(angle));
  };
  const bool is_whole = sweep_of_degrees(edge.number(50), edge.number(51)).is_whole();
  const double from = parameter(edge.number(50));
  const Sweep sweep = sweep_of(from, is_whole ? from : parameter(edge.number(51)));
  const Ellipse ellipse{edge.point(10), major, way * ratio * geometry::left_of(major)};
  go_to(ellipse.centre + math::cos(sweep.from_rad) * ellipse.first +
        math::sin(sweep.from_rad) * ellipse.second);
  pen_.ellipse(ellipse, sweep.from_rad, sweep.by_rad);
}

void EdgePath::draw_spline(const Groups& edge) {
  Spline spline;
  spline.degree = edge.integer(94, 3);
  for (const Group& group : edge.all()) {
    if (group.code == 40)
      spline.knots.push_back(group.number);
    else if (group.code == 10)
      spline.points.push_back({{group.number, 0}});
    else if (group.code == 20 && !spline.points.empty())
      spline.points.back().at.v = group.number;
    else if (group.code == 42 && !spline.points.empty())
      spline.points.back().weight = group.number;
  }
  if (const std::string fault = fault_of(spline); !fault.empty())
    return subject_.refuse("has an edge that is a spline and " + fault);
  go_to(begin_of(spline));
  drawing::draw(spline, pen_);
}

void draw_edges(const Groups& path, Subject& subject, Pen& pen) {
  EdgePath edges(subject, pen);
  for (const Groups& edge : parted(path.all(), kEdge)) edges.draw(edge);
  edges.end();
}

}  // namespace

void draw_hatch(Subject& subject) {
  constexpr int kOutline = 2;  // a polyline
  const std::vector<Groups> paths = parted(paths_of(subject.record()), kPath);
  if (paths.empty()) return subject.refuse("has no boundary (group 92)");
  Pen pen(subject.canvas(), subject.entity(), subject.to_mm());
  for (const Groups& path : paths) {
    const bool is_outline = (path.integer(kPath) & kOutline) != 0;
    if (is_outline)
      draw_outline(path, pen);
    else
      draw_edges(path, subject, pen);
  }
}

}  // namespace kerf::drawing::dxf
