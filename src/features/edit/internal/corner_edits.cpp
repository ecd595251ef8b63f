#include "features/edit/internal/corner_edits.hpp"

#include <cmath>
#include <utility>

#include "features/edit/internal/refusing.hpp"
#include "geometry/angle.hpp"
#include "geometry/contour/edit.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;
using contour::Edge;
using contour::Vec2;
using End = Outline::End;

/// A corner: the end that leads to it, and the element that begins in it.
struct Corner {
  End before;
  std::size_t after = 0;
  Edge first;  // in the direction of the contour
  Edge second;
};

// What is put into a corner: the three edges that are there then, of an open contour; or why not.
using Blended = tl::expected<Contour, contour::DoesNotFit>;

Editing<Corner> corner_of(const Outline& outline, std::size_t number) {
  const auto second = element_of(outline, number);
  if (!second) return tl::make_unexpected(second.error());
  const auto before = outline.joined({number, true});
  if (!before) {
    return refused(Code::edit_no_meeting,
                   "NO ELEMENT MEETS THE BEGINNING OF " + element_text(outline, number));
  }
  Edge first = *outline.find(before->element);
  if (before->is_start) first = reversed(first);
  return Corner{*before, number, first, *second};
}

bool is_of_lines(const Corner& corner) {
  return corner.first.bulge == 0 && corner.second.bulge == 0;
}

// Whether two lines are one.
bool goes_on(const Corner& corner) {
  constexpr double kStraight = 1e-9;  // sine of the angle
  const Vec2 in = geometry::unit(corner.first.to - corner.first.from);
  const Vec2 out = geometry::unit(corner.second.to - corner.second.from);
  return dot(in, out) > 0 && std::fabs(cross(in, out)) < kStraight;
}

Contour contour_of(const Corner& corner) {
  return {{{corner.first.from, corner.first.bulge, corner.first.owner},
           {corner.second.from, corner.second.bulge, corner.second.owner},
           {corner.second.to}},
          false};
}

// Puts the three edges in place of the corner.
void put(Outline& outline, const Corner& corner, const Contour& blended) {
  const Edge first = contour::edge_of(blended, 0);
  const Edge blend = contour::edge_of(blended, 1);
  // As it goes along the contour, behind the element before the corner, which may vanish.
  if (corner.before.is_start) {
    outline.add(blend);
  } else {
    outline.insert_after(corner.before.element, blend);
  }
  outline.set(corner.before.element, corner.before.is_start ? reversed(first) : first);
  outline.set(corner.after, contour::edge_of(blended, 2));
}

tl::unexpected<EditFault> does_not_fit(const Outline& outline, const Corner& corner,
                                       const std::string& what, const contour::DoesNotFit& lack) {
  if (!std::isfinite(lack.needs_mm)) {
    return refused(
        Code::edit_does_not_fit,
        what + " TOUCHES NOT BOTH " + elements_text(outline, corner.before.element, corner.after));
  }
  const std::size_t element = lack.edge == 0 ? corner.before.element : corner.after;
  return refused(Code::edit_does_not_fit, what + " NEEDS " + shown(lack.needs_mm) + " mm OF " +
                                              element_text(outline, element) + ", IT HAS " +
                                              shown(lack.has_mm));
}

template <typename Blend>
Editing<void> blend_corner(Outline& outline, std::size_t number, const Blend& blend) {
  const auto corner = corner_of(outline, number);
  if (!corner) return tl::make_unexpected(corner.error());
  const Editing<Blended> blended = blend(outline, *corner);
  if (!blended) return tl::make_unexpected(blended.error());
  if (!*blended) {
    return does_not_fit(outline, *corner, blend.what(), blended->error());
  }
  if ((*blended)->vertices.size() == 4) put(outline, *corner, **blended);
  return {};
}

std::vector<std::size_t> corners_of_lines(const Outline& outline) {
  std::vector<std::size_t> corners;
  for (std::size_t element = 0; element < outline.size(); ++element) {
    if (outline.find(element) == nullptr) continue;
    const auto corner = corner_of(outline, element);
    if (corner && is_of_lines(*corner) && !goes_on(*corner)) corners.push_back(element);
  }
  return corners;
}

template <typename Blend>
Editing<void> blend_corners(Outline& outline, std::optional<std::size_t> corner,
                            const Blend& blend) {
  if (corner) return blend_corner(outline, *corner, blend);
  Outline all = outline;
  for (const std::size_t number : corners_of_lines(outline)) {
    const auto done = blend_corner(all, number, blend);
    if (!done) return done;
  }
  outline = std::move(all);
  return {};
}

struct Fillet {
  double radius = 0;

  [[nodiscard]] std::string what() const { return "FILLET " + shown(radius); }
  Editing<Blended> operator()(const Outline&, const Corner& corner) const {
    return contour::fillet(contour_of(corner), 1, radius);
  }
};

// A length that is one with all of an edge is all of it.
double fitted(double wish, const Edge& edge) {
  constexpr double kSame_mm = 1e-9;
  const double has = contour::length(edge);
  return std::fabs(wish - has) <= kSame_mm ? has : wish;
}

struct Chamfer {
  const ChamferCorner& wish;

  [[nodiscard]] std::string what() const {
    const double longer = wish.angle_deg ? wish.before : std::max(wish.before, wish.after);
    return "CHAMFER " + shown(longer);
  }

  Editing<Blended> operator()(const Outline& outline, const Corner& corner) const {
    const auto after = length_after(outline, corner);
    if (!after) return tl::make_unexpected(after.error());
    return contour::chamfer(contour_of(corner), 1, fitted(wish.before, corner.first),
                            fitted(*after, corner.second));
  }

 private:
  // By the triangle of corner, d and the angle at its end.
  [[nodiscard]] Editing<double> length_after(const Outline& outline, const Corner& corner) const {
    if (!wish.angle_deg) return wish.after;
    const std::string both = elements_text(outline, corner.before.element, corner.after);
    if (!is_of_lines(corner)) {
      return refused(Code::edit_does_not_fit,
                     "A CHAMFER BY ITS ANGLE IS BETWEEN TWO LINES, NOT " + both);
    }
    const Vec2 back = corner.first.from - corner.first.to;
    const Vec2 on = corner.second.to - corner.second.from;
    const double at_corner = math::atan2(std::fabs(cross(back, on)), dot(back, on));
    const double angle = geometry::radians(*wish.angle_deg);
    const double opposite = math::sin(at_corner + angle);
    if (!(at_corner + angle < geometry::radians(180)) || !(opposite > 0)) {
      return refused(Code::edit_does_not_fit,
                     what() + " AT " + shown(*wish.angle_deg) + "° TOUCHES NOT BOTH " + both);
    }
    return wish.before * math::sin(angle) / opposite;
  }
};

}  // namespace

Editing<void> fillet(Outline& outline, const FilletCorner& wish) {
  return blend_corners(outline, wish.corner, Fillet{wish.radius});
}

Editing<void> chamfer(Outline& outline, const ChamferCorner& wish) {
  return blend_corners(outline, wish.corner, Chamfer{wish});
}

}  // namespace kerf::features
