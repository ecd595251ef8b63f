#include "process/along.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/contour/edge.hpp"
#include "process/weave.hpp"

namespace kerf::process {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kNothing_mm = 1e-9;
constexpr double kRadian = std::numbers::pi / 180;

Vec2 turned(Vec2 v, double angle_rad) {
  const auto [sine, cosine] = math::sine_cosine(angle_rad);
  return {cosine * v.u - sine * v.v, sine * v.u + cosine * v.v};
}

/// The edges of a contour from one distance along it on, once round or to its end.
std::vector<Edge> edges_from(const Contour& path, double start) {
  std::vector<Edge> edges;
  const std::size_t count = edge_count(path);
  const contour::Place place = place_at_length(path, start);
  const Edge first = edge_of(path, place.edge);
  const bool begins_inside = place.share > 0 && place.share < 1;
  const std::size_t begin = place.share >= 1 ? (place.edge + 1) % count : place.edge;
  if (begins_inside) edges.push_back(part(first, place.share, 1));
  for (std::size_t i = begins_inside ? 1 : 0; i < count; ++i)
    edges.push_back(edge_of(path, (begin + i) % count));
  if (begins_inside) edges.push_back(part(first, 0, place.share));
  return edges;
}

std::vector<Edge> edges_of(const Contour& path) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < edge_count(path); ++i) edges.push_back(edge_of(path, i));
  return edges;
}

/// The edges that are made: of a closed contour once round, of an open one by its second entry
/// backwards.
std::vector<Edge> course_of(const Along& along, std::size_t entry) {
  if (along.path.is_closed) return edges_from(along.path, along.starts[entry]);
  return edges_of(entry == 0 ? along.path : reversed(along.path));
}

double length_of(const std::vector<Edge>& edges) {
  double sum = 0;
  for (const Edge& edge : edges) sum += length(edge);
  return sum;
}

/// The first `distance` mm of the edges, again.
std::vector<Edge> beginning_of(const std::vector<Edge>& edges, double distance) {
  std::vector<Edge> result;
  for (const Edge& edge : edges) {
    if (distance <= kNothing_mm) break;
    const double whole = length(edge);
    result.push_back(distance >= whole ? edge : part(edge, 0, distance / whole));
    distance -= whole;
  }
  return result;
}

/// A stretch of the course with another power.
struct Stretch {
  double from = 0;
  double to = 0;
  double power = 0;
};

std::vector<Stretch> gaps_of(const Tabs& tabs, double kerf, double whole) {
  std::vector<Stretch> gaps;
  if (!tabs.are_asked_for()) return gaps;
  const auto count = tabs.count ? static_cast<double>(*tabs.count)
                                : std::max(1.0, std::floor(whole / *tabs.spacing_mm));
  const double half = 0.5 * (tabs.width_mm + kerf);
  for (double i = 0; i < count; ++i) {
    const double middle = (i + 0.5) / count * whole;
    gaps.push_back({middle - half, middle + half, tabs.power_percent / 100});
  }
  return gaps;
}

/// Power from nothing and to nothing, linear, in steps of at most 0.2 mm.
void append_ramp(double from, double length_mm, bool rises, std::vector<Stretch>& stretches) {
  constexpr double kStep_mm = 0.2;
  if (length_mm <= 0) return;
  const double steps = std::ceil(length_mm / kStep_mm - 1e-9);
  for (double i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps;
    stretches.push_back({from + i / steps * length_mm, from + (i + 1) / steps * length_mm,
                         rises ? share : 1 - share});
  }
}

/// Appends edges as legs, parted where the power changes.
void append_legs(const std::vector<Edge>& edges, const std::vector<Stretch>& stretches, Way& way) {
  double at = 0;
  for (const Edge& edge : edges) {
    const double whole = length(edge);
    std::vector<double> cuts{0, whole};
    for (const Stretch& stretch : stretches) {
      for (const double cut : {stretch.from - at, stretch.to - at})
        if (cut > kNothing_mm && cut < whole - kNothing_mm) cuts.push_back(cut);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double middle = at + 0.5 * (cuts[i] + cuts[i + 1]);
      double power = 1;
      for (const Stretch& stretch : stretches)
        if (middle > stretch.from && middle < stretch.to) power = stretch.power;
      const Edge piece = cuts.size() == 2 ? edge : part(edge, cuts[i] / whole, cuts[i + 1] / whole);
      way.legs.push_back({piece.to, piece.bulge, power});
    }
    at += whole;
  }
}

Vec2 scrap_side(Vec2 direction, bool is_left) {
  const Vec2 left = geometry::left_of(direction);
  return is_left ? left : -left;
}

/// The point that a lead begins at which ends in `at` in the direction `on`, and its bulge.
struct LeadLeg {
  Vec2 far;
  double bulge = 0;
};

LeadLeg lead_of(const Lead& lead, double share, Vec2 at, Vec2 on, bool scrap_is_left) {
  const Vec2 away = scrap_side(on, scrap_is_left);
  const double side = scrap_is_left ? 1 : -1;
  if (lead.kind == Lead::Kind::line) {
    // 90 degrees: square; less: along the way.
    const Vec2 back = turned(-on, -side * lead.angle_deg * kRadian);
    return {at + share * lead.length_mm * back, 0};
  }
  const double turn = lead.angle_deg * kRadian;
  const double radius = share * lead.radius_mm;
  const Vec2 centre = at + radius * away;
  return {centre + turned(at - centre, -side * turn), side * math::tan(0.25 * turn)};
}

bool has_leads(const Along& along, const AlongRules& rules) {
  return along.path.is_closed || rules.leads_open;
}

LeadShare share_of(const Along& along, std::size_t entry) {
  return along.leads.empty() ? LeadShare{} : along.leads[entry];
}

/// Where the course begins and its direction there; likewise where it ends behind its overcut.
struct Gate {
  Vec2 at;
  Vec2 on;
};

Gate begin_gate(const std::vector<Edge>& course) {
  return {course.front().from, geometry::unit(tangent_at_start(course.front()))};
}

Gate end_gate(const std::vector<Edge>& course) {
  return {course.back().to, geometry::unit(tangent_at_end(course.back()))};
}

std::vector<Edge> course_with_overcut(const Along& along, std::size_t entry,
                                      const AlongRules& rules) {
  std::vector<Edge> course = course_of(along, entry);
  if (!along.path.is_closed || rules.overcut <= 0) return course;
  const double most = length_of(course);
  for (const Edge& edge : beginning_of(course, std::min(rules.overcut, most)))
    course.push_back(edge);
  return course;
}

Way lead_in_at(const Gate& gate, const Along& along, std::size_t entry, const AlongRules& rules) {
  const double share = share_of(along, entry).in;
  if (rules.lead_in.kind == Lead::Kind::none || !has_leads(along, rules) || share <= 0)
    return {gate.at, {}, 0};
  const LeadLeg leg = lead_of(rules.lead_in, share, gate.at, gate.on, along.scrap_is_left);
  return {leg.far, {{gate.at, leg.bulge, 1}}, 0};
}

Way lead_out_at(const Gate& gate, const Along& along, std::size_t entry, const AlongRules& rules) {
  const double share = share_of(along, entry).out;
  if (rules.lead_out.kind == Lead::Kind::none || !has_leads(along, rules) || share <= 0)
    return {gate.at, {}, 0};
  // As the way in of a course in the other direction, whose scrap is on its other side.
  const LeadLeg leg = lead_of(rules.lead_out, share, gate.at, -gate.on, !along.scrap_is_left);
  return {gate.at, {{leg.far, -leg.bulge, 1}}, 0};
}

}  // namespace

std::size_t entry_count(const Along& along) {
  return along.path.is_closed ? along.starts.size() : 2;
}

Way lead_in_of(const Along& along, std::size_t entry, const AlongRules& rules) {
  return lead_in_at(begin_gate(course_of(along, entry)), along, entry, rules);
}

Way lead_out_of(const Along& along, std::size_t entry, const AlongRules& rules) {
  return lead_out_at(end_gate(course_with_overcut(along, entry, rules)), along, entry, rules);
}

Way way_of(const Along& along, std::size_t entry, const AlongRules& rules) {
  std::vector<Edge> course = course_of(along, entry);
  const double once = length_of(course);
  std::vector<Stretch> stretches = gaps_of(rules.tabs, rules.kerf, once);
  if (!along.path.is_closed) stretches.clear();
  course = course_with_overcut(along, entry, rules);
  const Gate begin = begin_gate(course);
  const Gate end = end_gate(course);
  if (rules.weave.shape != Weave::Shape::none) course = woven(course, rules.weave);
  const double whole = length_of(course);
  append_ramp(0, std::min(rules.ramp_in, 0.5 * whole), true, stretches);
  const double out = std::min(rules.ramp_out, 0.5 * whole);
  append_ramp(whole - out, out, false, stretches);
  Way way = lead_in_at(begin, along, entry, rules);
  const Way out_of_it = lead_out_at(end, along, entry, rules);
  way.pierce_s = rules.pierce_s;
  append_legs(course, stretches, way);
  way.legs.insert(way.legs.end(), out_of_it.legs.begin(), out_of_it.legs.end());
  return way;
}

Entry entry_of(const Along& along, std::size_t entry, const AlongRules& rules) {
  const bool is_plain = rules.lead_in.kind == Lead::Kind::none &&
                        rules.lead_out.kind == Lead::Kind::none && rules.overcut <= 0;
  if (is_plain && !along.path.is_closed) {
    const Vec2 first = along.path.vertices.front().point;
    const Vec2 last = along.path.vertices.back().point;
    return entry == 0 ? Entry{first, last} : Entry{last, first};
  }
  if (is_plain) {
    const Vec2 at = point_at(along.path, place_at_length(along.path, along.starts[entry]));
    return {at, at};
  }
  return {lead_in_of(along, entry, rules).begin, lead_out_of(along, entry, rules).end()};
}

std::vector<double> starts_of(const Contour& path, StartAt start, const AlongRules& rules) {
  constexpr std::size_t kMost = 64;
  constexpr double kCorner = 1e-6;  // radians
  if (!path.is_closed) return {};
  if (start == StartAt::first) return {0};
  const auto reach = [](const Lead& lead) {
    return lead.kind == Lead::Kind::line ? lead.length_mm
                                         : (lead.kind == Lead::Kind::arc ? lead.radius_mm : 0);
  };
  const double clear = 2 * std::max(reach(rules.lead_in), reach(rules.lead_out));
  std::vector<double> middles;
  std::vector<double> vertices;
  std::vector<double> corners;
  double at = 0;
  const std::size_t count = edge_count(path);
  for (std::size_t i = 0; i < count; ++i) {
    const Edge edge = edge_of(path, i);
    const Vec2 before = tangent_at_end(edge_of(path, (i + count - 1) % count));
    const Vec2 after = tangent_at_start(edge);
    vertices.push_back(at);
    const double turn = math::atan2(geometry::cross(before, after), geometry::dot(before, after));
    if (std::abs(turn) > kCorner) corners.push_back(at);
    const double long_mm = length(edge);
    if (clear > 0 && long_mm >= clear) middles.push_back(at + 0.5 * long_mm);
    at += long_mm;
  }
  std::vector<double>& chosen = start == StartAt::corner && !corners.empty() ? corners
                                : !middles.empty()                           ? middles
                                                                             : vertices;
  if (chosen.size() <= kMost) return chosen;
  std::vector<double> some;
  for (std::size_t i = 0; i < kMost; ++i) some.push_back(chosen[i * chosen.size() / kMost]);
  return some;
}

}  // namespace kerf::process
