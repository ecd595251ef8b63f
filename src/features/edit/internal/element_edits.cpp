#include "features/edit/internal/element_edits.hpp"

#include <limits>
#include <utility>

#include "features/edit/arc_ways.hpp"
#include "features/edit/internal/refusing.hpp"
#include "geometry/angle.hpp"
#include "geometry/contour/edit.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Edge;
using contour::Vec2;
using End = Outline::End;

/// Puts another edge in place of an element; what was joined to its ends follows them.
void replace(Outline& outline, std::size_t element, const Edge& edge) {
  const auto at_start = outline.joined({element, true});
  const auto at_end = outline.joined({element, false});
  const Edge old = *outline.find(element);
  outline.set(element, edge);
  if (at_start && !(old.from == edge.from)) outline.move_end(*at_start, edge.from);
  const bool is_there = at_end && outline.find(at_end->element) != nullptr;
  if (is_there && !(old.to == edge.to)) outline.move_end(*at_end, edge.to);
}

Edge line_of(const ModifyLine& wish, const Edge& old) {
  Edge line = old;
  if (wish.from) line.from = *wish.from;
  if (wish.to) line.to = *wish.to;
  if (!wish.length && !wish.angle_deg) return line;
  const Vec2 way = old.to - old.from;
  const double length = wish.length ? *wish.length : geometry::length(way);
  Vec2 direction = geometry::unit(way);
  if (wish.angle_deg) {
    const auto [sine, cosine] = geometry::sine_cosine_deg(*wish.angle_deg);
    direction = {cosine, sine};
  }
  line.to = line.from + length * direction;
  return line;
}

Editing<void> no_arc(const Outline& outline, std::size_t element, const std::string& why) {
  return refused(Code::edit_does_not_fit, element_text(outline, element) + ": " + why);
}

double angle_deg(Vec2 arm) { return geometry::degrees(math::atan2(arm.v, arm.u)); }

// Its circle, or its part of it, is another one.
std::optional<Edge> on_circle(const ModifyArc& wish, const Edge& old) {
  const Vec2 centre = contour::centre(old);
  const double start = wish.start_deg ? *wish.start_deg : angle_deg(old.from - centre);
  const double end = wish.end_deg ? *wish.end_deg : angle_deg(old.to - centre);
  return arc_about(wish.centre ? *wish.centre : centre,
                   wish.radius ? *wish.radius : contour::radius(old), start, end, old.bulge < 0);
}

bool keeps_its_ends(const ModifyArc& wish) {
  return wish.radius && !wish.centre && !wish.start_deg && !wish.end_deg;
}

/// Two ends that are to be joined.
struct Pair {
  End first;
  End second;
};

double distance(const Outline& outline, const Pair& pair) {
  return geometry::length(outline.point(pair.first) - outline.point(pair.second));
}

// Elements of the contour go on from the end of one to the beginning of the other; those that were
// drawn may have been drawn either way.
std::vector<Pair> pairs_of(const Outline& outline, const JoinElements& wish) {
  const auto [a, b] = wish;
  if (outline.after(a) == b) return {{{a, false}, {b, true}}};
  if (outline.after(b) == a) return {{{a, true}, {b, false}}};
  std::vector<Pair> pairs{{{a, false}, {b, true}}, {{a, true}, {b, false}}};
  if (outline.is_drawn(a) || outline.is_drawn(b)) {
    pairs.push_back({{a, false}, {b, false}});
    pairs.push_back({{a, true}, {b, true}});
  }
  return pairs;
}

Pair nearest_pair(const Outline& outline, const JoinElements& wish) {
  const std::vector<Pair> pairs = pairs_of(outline, wish);
  Pair best = pairs.front();
  for (const Pair& pair : pairs) {
    if (distance(outline, pair) < distance(outline, best)) best = pair;
  }
  return best;
}

// An edge that comes from elsewhere and ends in this end, and back.
Edge leading_to(const Edge& edge, bool is_start) { return is_start ? reversed(edge) : edge; }

}  // namespace

Editing<void> modify(Outline& outline, const ModifyLine& wish) {
  const auto old = element_of(outline, wish.element);
  if (!old) return tl::make_unexpected(old.error());
  if (old->bulge != 0) {
    return refused(Code::edit_element_unknown,
                   element_text(outline, wish.element) + " IS AN ARC: TAKE modify-arc");
  }
  replace(outline, wish.element, line_of(wish, *old));
  return {};
}

Editing<void> modify(Outline& outline, const ModifyArc& wish) {
  const auto old = element_of(outline, wish.element);
  if (!old) return tl::make_unexpected(old.error());
  if (old->bulge == 0) {
    return refused(Code::edit_element_unknown,
                   element_text(outline, wish.element) + " IS A LINE: TAKE modify-line");
  }
  std::optional<Edge> arc;
  if (wish.through.size() == 3) {
    arc = arc_through(wish.through[0], wish.through[1], wish.through[2]);
    if (!arc) return no_arc(outline, wish.element, "NO ARC GOES THROUGH THE THREE POINTS");
  } else if (keeps_its_ends(wish)) {
    arc = with_radius(*old, *wish.radius);
    if (!arc) {
      return no_arc(outline, wish.element,
                    "RADIUS " + shown(*wish.radius) + " IS TOO SMALL FOR ENDS THAT ARE " +
                        shown(geometry::length(old->to - old->from)) + " mm APART");
    }
  } else {
    arc = on_circle(wish, *old);
    if (!arc) return no_arc(outline, wish.element, "A WHOLE CIRCLE IS TWO ELEMENTS");
  }
  arc->owner = old->owner;
  replace(outline, wish.element, *arc);
  return {};
}

Editing<void> join(Outline& outline, const JoinElements& wish) {
  for (const std::size_t element : {wish.first, wish.second}) {
    const auto found = element_of(outline, element);
    if (!found) return tl::make_unexpected(found.error());
  }
  if (wish.first == wish.second) {
    return refused(Code::edit_no_meeting,
                   element_text(outline, wish.first) + " CANNOT BE JOINED TO ITSELF");
  }
  const Pair pair = nearest_pair(outline, wish);
  const Edge first = leading_to(*outline.find(wish.first), pair.first.is_start);
  const Edge second = leading_to(*outline.find(wish.second), pair.second.is_start);
  const auto joined = contour::join(first, reversed(second));
  if (!joined) {
    return refused(Code::edit_no_meeting,
                   elements_text(outline, wish.first, wish.second) + " DO NOT MEET");
  }
  outline.set(wish.first, leading_to(joined->first, pair.first.is_start));
  outline.set(wish.second, leading_to(reversed(joined->second), pair.second.is_start));
  return {};
}

Editing<void> remove(Outline& outline, const DeleteElement& wish) {
  const auto found = element_of(outline, wish.element);
  if (!found) return tl::make_unexpected(found.error());
  outline.remove(wish.element);
  return {};
}

}  // namespace kerf::features
