#include "process/internal/scanlines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "geometry/contour/edge.hpp"

namespace kerf::process {
namespace {

using contour::Edge;

/// A part of an edge that only rises or only falls, in the plane turned by the hatch: each line
/// meets it once, its lower end counted and its upper one not.
struct Rise {
  double low = 0;
  double high = 0;
  bool is_up = true;
  std::uint32_t group = 0;  ///< outlines of one entity are filled by its rule
  // Of a line: where it is at `low`, and how far it goes per mm. Of an arc: its circle, and which
  // side.
  double at_low = 0;
  double slope = 0;
  double centre_u = 0;
  double centre_v = 0;
  double radius = 0;  // 0: a line
  double side = 1;

  [[nodiscard]] double at(double v) const {
    if (radius == 0) return at_low + slope * (v - low);
    const double up = v - centre_v;
    return centre_u + side * std::sqrt(std::max(0.0, radius * radius - up * up));
  }
};

void append_line(Vec2 from, Vec2 to, std::uint32_t group, std::vector<Rise>& rises) {
  if (from.v == to.v) return;
  const bool is_up = to.v > from.v;
  const Vec2 low = is_up ? from : to;
  const Vec2 high = is_up ? to : from;
  Rise rise;
  rise.low = low.v;
  rise.high = high.v;
  rise.is_up = is_up;
  rise.group = group;
  rise.at_low = low.u;
  rise.slope = (high.u - low.u) / (high.v - low.v);
  rises.push_back(rise);
}

/// Arcs are parted at the top and the bottom of their circle.
void append_arc(const Edge& edge, std::uint32_t group, std::vector<Rise>& rises) {
  const Vec2 middle = centre(edge);
  const double sweep = sweep_rad(edge);
  const double begin = math::atan2(edge.from.v - middle.v, edge.from.u - middle.u);
  std::vector<double> turns{0};
  constexpr double kHalf = std::numbers::pi;
  for (int k = -6; k <= 6; ++k) {
    const double share = (kHalf / 2 + k * kHalf - begin) / sweep;
    if (share > 1e-12 && share < 1 - 1e-12) turns.push_back(share);
  }
  turns.push_back(1);
  std::sort(turns.begin(), turns.end());
  const double r = radius(edge);
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    const auto level = [&](double share) {
      if (share == 0) return edge.from.v;
      if (share == 1) return edge.to.v;
      return middle.v + (math::sin(begin + share * sweep) > 0 ? r : -r);
    };
    Rise rise;
    const double from = level(turns[i]);
    const double to = level(turns[i + 1]);
    if (from == to) continue;
    rise.low = std::min(from, to);
    rise.high = std::max(from, to);
    rise.is_up = to > from;
    rise.group = group;
    rise.centre_u = middle.u;
    rise.centre_v = middle.v;
    rise.radius = r;
    rise.side = math::cos(begin + 0.5 * (turns[i] + turns[i + 1]) * sweep) < 0 ? -1 : 1;
    rises.push_back(rise);
  }
}

Edge turned(const Edge& edge, const drawing::Affine& turn) {
  return {turn(edge.from), turn(edge.to), edge.bulge, edge.owner};
}

std::vector<Rise> rises_of(const std::vector<Outline>& outlines, const drawing::Affine& turn,
                           contour::Box& box) {
  std::vector<Rise> rises;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < edge_count(outline.path); ++i) {
      const Edge edge = turned(edge_of(outline.path, i), turn);
      box.take(extents(edge));
      if (edge.bulge == 0)
        append_line(edge.from, edge.to, outline.entity, rises);
      else
        append_arc(edge, outline.entity, rises);
    }
  }
  std::sort(rises.begin(), rises.end(), [](const Rise& a, const Rise& b) { return a.low < b.low; });
  return rises;
}

struct Crossing {
  double at;
  const Rise* rise;
};

/// What is inside between crossings in ascending order.
class Inside {
 public:
  explicit Inside(const std::map<std::uint32_t, drawing::FillRule>& rules) : rules_(rules) {}

  /// True where the point behind the crossing is inside.
  bool pass(const Crossing& crossing) {
    int& winding = windings_[crossing.rise->group];
    const bool before = is_in(crossing.rise->group, winding);
    winding += crossing.rise->is_up ? 1 : -1;
    if (before != is_in(crossing.rise->group, winding)) is_inside_ = !is_inside_;
    return is_inside_;
  }
  [[nodiscard]] bool is_inside() const { return is_inside_; }

 private:
  [[nodiscard]] bool is_in(std::uint32_t group, int winding) const {
    const bool counts_all = rules_.find(group)->second == drawing::FillRule::non_zero;
    return counts_all ? winding != 0 : winding % 2 != 0;
  }

  const std::map<std::uint32_t, drawing::FillRule>& rules_;
  std::map<std::uint32_t, int> windings_;
  bool is_inside_ = false;
};

std::vector<Run> runs_of(std::vector<Crossing>& crossings,
                         const std::map<std::uint32_t, drawing::FillRule>& rules, double inset) {
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
  std::vector<Run> runs;
  Inside inside(rules);
  double from = 0;
  for (const Crossing& crossing : crossings) {
    const bool was_inside = inside.is_inside();
    const bool is_inside = inside.pass(crossing);
    if (!was_inside && is_inside) from = crossing.at;
    if (!was_inside || is_inside) continue;
    const Run run{from + inset, crossing.at - inset, 1};
    if (run.to - run.from <= 1e-9) continue;
    if (!runs.empty() && run.from - runs.back().to <= 1e-9)
      runs.back().to = run.to;
    else
      runs.push_back(run);
  }
  return runs;
}

/// The same line made the other way.
void turn_round(ScanLine& line) {
  const double whole = line.runs.back().to;
  line.origin = line.origin + whole * line.along;
  line.along = -line.along;
  std::reverse(line.runs.begin(), line.runs.end());
  for (Run& run : line.runs) run = {whole - run.to, whole - run.from, run.power};
}

}  // namespace

std::vector<ScanLine> hatched(const std::vector<Outline>& outlines, const Hatch& hatch) {
  const double angle = hatch.angle_deg * std::numbers::pi / 180;
  const drawing::Affine level = drawing::Affine::turned(-angle);
  const drawing::Affine back = drawing::Affine::turned(angle);
  contour::Box box;
  const std::vector<Rise> rises = rises_of(outlines, level, box);
  std::vector<ScanLine> lines;
  if (rises.empty()) return lines;
  std::map<std::uint32_t, drawing::FillRule> rules;
  for (const Outline& outline : outlines) rules[outline.entity] = outline.rule;
  const double height = box.high.v - box.low.v;
  const double count = std::max(1.0, std::floor(height / hatch.spacing + 0.5));
  const double middle = 0.5 * (box.high.v + box.low.v);
  std::vector<const Rise*> active;
  std::size_t next = 0;
  std::vector<Crossing> crossings;
  for (double k = 0; k < count; ++k) {
    const double v = middle + (k - 0.5 * (count - 1)) * hatch.spacing;
    for (; next < rises.size() && rises[next].low <= v; ++next) active.push_back(&rises[next]);
    std::erase_if(active, [&](const Rise* rise) { return rise->high <= v; });
    crossings.clear();
    for (const Rise* rise : active) crossings.push_back({rise->at(v), rise});
    ScanLine line{back({0, v}), back.direction({1, 0}), runs_of(crossings, rules, hatch.inset)};
    if (line.runs.empty()) continue;
    if (hatch.is_bidirectional && lines.size() % 2 == 1) turn_round(line);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace kerf::process
