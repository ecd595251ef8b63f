#include "features/edit/internal/contour_checks.hpp"

#include <cmath>
#include <optional>

#include "features/edit/internal/refusing.hpp"
#include "features/path/tolerance.hpp"
#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/crossing.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;
using contour::Meeting;
using contour::Vec2;

bool is_joined(const Outline::Step& step, const Outline::Step& next) {
  return geometry::length(step.edge.to - next.edge.from) <= kSamePoint_mm;
}

std::string contour_text(const Outline& outline) { return "THE CONTOUR" + outline.owner(); }

// True also of what is too far away to be anywhere.
bool encloses_nothing(const Contour& contour) {
  if (!contour::is_sound(contour)) return true;
  if (!contour.is_closed) return contour::edge_count(contour) == 0;
  if (std::fabs(contour::area(contour)) > kEmptyArea_mm2) return false;
  // The two wings of a bow tie, gone round in two senses, are something all the same.
  const auto meeting = contour::meeting_of({&contour, 1}, kSamePoint_mm);
  return !meeting || !meeting->is_crossing;
}

std::optional<std::size_t> first_gap(const MadeContour& made) {
  const std::size_t count = made.steps.size();
  const std::size_t last = made.outline->is_closed() ? count : count - 1;
  for (std::size_t i = 0; i < last; ++i) {
    if (!is_joined(made.steps[i], made.steps[(i + 1) % count])) return i;
  }
  return std::nullopt;
}

/// The contours of a layer; edge k of each is its step k.
class Layer {
 public:
  Layer(const std::vector<MadeContour>& made, const AxisNames& names) : made_(made), names_(names) {
    for (const MadeContour& one : made) contours_.push_back(bridged(one));
  }

  Editing<void> check() const {
    const auto meeting = contour::meeting_of(contours_, kSamePoint_mm);
    if (meeting && meeting->is_crossing) return crossing(*meeting, " CROSS AT ");
    if (!contours_.front().is_closed) return meeting ? crossing(*meeting, " MEET AT ") : none();
    if (contours_.size() == 1 && !meeting) return {};
    const std::span holes = std::span(contours_).subspan(1);
    if (contour::bound_one_area(contours_.front(), holes)) return {};
    if (const auto misplaced = check_places(); !misplaced) return misplaced;
    if (meeting) return crossing(*meeting, " MEET AT ");
    return refused(Code::edit_crosses_itself, "THE CONTOURS CROSS");
  }

 private:
  static Editing<void> none() { return {}; }

  [[nodiscard]] std::size_t element(contour::EdgeName name) const {
    return made_[name.contour].steps[name.edge].element;
  }

  [[nodiscard]] Editing<void> crossing(const Meeting& meeting, const std::string& how) const {
    const Outline& first = *made_[meeting.first.contour].outline;
    const Outline& second = *made_[meeting.second.contour].outline;
    const std::string both = meeting.first.contour == meeting.second.contour
                                 ? in_order(first, element(meeting.first), element(meeting.second))
                                 : element_text(first, element(meeting.first)) + " AND " +
                                       element_text(second, element(meeting.second));
    return refused(Code::edit_crosses_itself, both + how + names_.place(meeting.point),
                   meeting.point);
  }
  static std::string in_order(const Outline& outline, std::size_t a, std::size_t b) {
    return elements_text(outline, std::min(a, b), std::max(a, b));
  }

  // No contour crosses another one: where a point of it lies, there lies all of it.
  [[nodiscard]] Editing<void> check_places() const {
    std::vector<contour::Box> boxes;
    for (const Contour& contour : contours_) boxes.push_back(contour::extents(contour));
    const contour::BoxTree tree(boxes);
    for (std::size_t i = 1; i < contours_.size(); ++i) {
      if (!is_inside(i, 0)) return misplaced(i, " IS NOT INSIDE THE CONTOUR");
      std::optional<std::size_t> round;
      tree.search(boxes[i], [&](std::uint32_t other) {
        if (other != 0 && other != i && !round && is_inside(i, other)) round = other;
      });
      if (round) return misplaced(i, " IS NOT APART FROM ISLAND " + name_of(*round));
    }
    return {};
  }

  [[nodiscard]] bool is_inside(std::size_t inner, std::size_t outer) const {
    const Contour& contour = contours_[inner];
    contour::Side side = contour::Side::border;
    for (std::size_t i = 0; i < contour::edge_count(contour) && side == contour::Side::border;
         ++i) {
      side = contour::side_of(contours_[outer],
                              contour::point_at(contour::edge_of(contour, i), 0.5), kSamePoint_mm);
    }
    return side != contour::Side::outside;
  }

  [[nodiscard]] Editing<void> misplaced(std::size_t island, const std::string& how) const {
    return refused(Code::edit_crosses_itself, "ISLAND " + name_of(island) + how);
  }
  // The number in " OF ISLAND 3".
  [[nodiscard]] std::string name_of(std::size_t contour) const {
    const std::string& owner = made_[contour].outline->owner();
    return owner.substr(owner.rfind(' ') + 1);
  }

  const std::vector<MadeContour>& made_;
  const AxisNames& names_;
  std::vector<Contour> contours_;
};

}  // namespace

std::string AxisNames::place(Vec2 point) const {
  if (turns) return "Z" + shown(point.u) + " X" + shown(2 * point.v);
  return "X" + shown(point.u) + " Y" + shown(point.v);
}

Contour bridged(const MadeContour& made) {
  Contour contour{{}, made.outline->is_closed()};
  const std::size_t count = made.steps.size();
  for (std::size_t i = 0; i < count; ++i) {
    const contour::Edge& edge = made.steps[i].edge;
    contour.vertices.push_back({edge.from, edge.bulge, edge.owner});
    const bool is_last = i + 1 == count && !contour.is_closed;
    if (is_last || !is_joined(made.steps[i], made.steps[(i + 1) % count])) {
      contour.vertices.push_back({edge.to, 0, edge.owner});
    }
  }
  return contour;
}

Editing<void> check_area(const std::vector<MadeContour>& made) {
  for (const MadeContour& one : made) {
    if (!encloses_nothing(bridged(one))) continue;
    return refused(Code::edit_no_area, contour_text(*one.outline) + " ENCLOSES NOTHING");
  }
  return {};
}

Editing<void> check_closed(const std::vector<MadeContour>& made) {
  for (const MadeContour& one : made) {
    const auto gap = first_gap(one);
    if (!gap) continue;
    const Outline::Step& step = one.steps[*gap];
    const Outline::Step& next = one.steps[(*gap + 1) % one.steps.size()];
    return refused(Code::edit_open,
                   contour_text(*one.outline) + " IS OPEN BY " +
                       shown(geometry::length(step.edge.to - next.edge.from)) +
                       " mm BETWEEN ELEMENTS " + std::to_string(step.element) + " AND " +
                       std::to_string(next.element),
                   step.edge.to);
  }
  return {};
}

Editing<void> check_apart(const std::vector<MadeContour>& made, const AxisNames& names) {
  return Layer(made, names).check();
}

}  // namespace kerf::features
