#include "features/edit/contour_edit.hpp"

#include <utility>

#include "features/edit/internal/contour_checks.hpp"
#include "features/edit/internal/corner_edits.hpp"
#include "features/edit/internal/element_edits.hpp"
#include "features/edit/internal/half_section.hpp"
#include "features/edit/internal/refusing.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/angle.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Vec2;
using Island = std::optional<std::size_t>;

constexpr double kRadiusOfDiameter = 0.5;

std::string island_text(std::size_t island) { return " OF ISLAND " + std::to_string(island); }

Outline outline_of(Contour contour, bool is_closed, std::string owner) {
  contour.is_closed = is_closed;
  return Outline(normal_form(contour), std::move(owner));
}

Editing<void> change_elements(Outline& outline, const AddElement& wish) {
  outline.add(wish.edge);
  return {};
}
Editing<void> change_elements(Outline& outline, const ModifyLine& wish) {
  return modify(outline, wish);
}
Editing<void> change_elements(Outline& outline, const ModifyArc& wish) {
  return modify(outline, wish);
}
Editing<void> change_elements(Outline& outline, const JoinElements& wish) {
  return join(outline, wish);
}
Editing<void> change_elements(Outline& outline, const ChamferCorner& wish) {
  return chamfer(outline, wish);
}
Editing<void> change_elements(Outline& outline, const FilletCorner& wish) {
  return fillet(outline, wish);
}
Editing<void> change_elements(Outline& outline, const DeleteElement& wish) {
  return remove(outline, wish);
}
// What is no edit of elements.
template <typename Other>
Editing<void> change_elements(Outline&, const Other&) {
  return {};
}

}  // namespace

ContourEdit::ContourEdit(const LayerContours& contours, bool turns)
    : turns_(turns), outer_(in_measure(contours.outer, turns ? kRadiusOfDiameter : 1)) {
  for (const Contour& island : contours.islands) {
    add_island(in_measure(island, turns ? kRadiusOfDiameter : 1));
  }
}

Editing<void> ContourEdit::apply(const EditOperation& operation, Island island) {
  const EditOperation here = turns_ ? in_measure(operation, kRadiusOfDiameter) : operation;
  return std::visit([&](const auto& wish) { return change(wish, island); }, here);
}

Editing<Outline*> ContourEdit::outline(Island island) {
  if (!island) return &outer_;
  if (*island < islands_.size() && islands_[*island]) return &*islands_[*island];
  return refused(base::Code::edit_layer_unknown,
                 "NO ISLAND " + std::to_string(*island) + ": THE CONTOUR HAS " +
                     (islands_.empty() ? "NONE" : "0 TO " + std::to_string(islands_.size() - 1)));
}

void ContourEdit::add_island(const Contour& contour) {
  islands_.emplace_back(outline_of(contour, true, island_text(islands_.size())));
}

template <typename Operation>
Editing<void> ContourEdit::change(const Operation& wish, Island island) {
  const auto found = outline(island);
  if (!found) return tl::make_unexpected(found.error());
  return change_elements(**found, wish);
}

Editing<void> ContourEdit::change(const ReplaceContour& wish, Island island) {
  const auto found = outline(island);
  if (!found) return tl::make_unexpected(found.error());
  Outline& old = **found;
  if (wish.contour) old = outline_of(*wish.contour, old.is_closed(), old.owner());
  if (!wish.islands) return {};
  islands_.clear();
  for (const Contour& contour : *wish.islands) add_island(contour);
  return {};
}

Editing<void> ContourEdit::change(const AddIsland& wish, Island /*island*/) {
  add_island(wish.contour);
  return {};
}

Editing<void> ContourEdit::change(const DeleteIsland& wish, Island /*island*/) {
  const auto found = outline(wish.island);
  if (!found) return tl::make_unexpected(found.error());
  islands_[wish.island].reset();
  return {};
}

template <typename Map>
void ContourEdit::move_all(Island island, const Map& moved) {
  if (!island) outer_.move_all(moved);
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    if (islands_[i] && (!island || *island == i)) islands_[i]->move_all(moved);
  }
}

Vec2 ContourEdit::centre() const {
  contour::Box box;
  for (const Outline::Step& step : outer_.steps()) box.take(contour::extents(step.edge));
  return box.is_empty() ? Vec2{} : box.middle();
}

Editing<void> ContourEdit::change(const MoveFeature& wish, Island island) {
  const auto found = outline(island);
  if (!found) return tl::make_unexpected(found.error());
  const Vec2 by = turns_ ? Vec2{wish.dz, wish.dx} : Vec2{wish.dx, wish.dy};
  move_all(island, [&](Vec2 point) { return point + by; });
  return {};
}

Editing<void> ContourEdit::change(const RotateFeature& wish, Island island) {
  const auto found = outline(island);
  if (!found) return tl::make_unexpected(found.error());
  const Vec2 about = wish.about ? *wish.about : centre();
  const auto [sine, cosine] = geometry::sine_cosine_deg(wish.deg);
  const double s = sine;
  const double c = cosine;
  move_all(island, [&](Vec2 point) {
    const Vec2 arm = point - about;
    return about + c * arm + s * geometry::left_of(arm);
  });
  return {};
}

Editing<void> ContourEdit::change(const ScaleFeature& wish, Island island) {
  const auto found = outline(island);
  if (!found) return tl::make_unexpected(found.error());
  const Vec2 about = wish.about ? *wish.about : centre();
  move_all(island, [&](Vec2 point) { return about + wish.factor * (point - about); });
  return {};
}

std::vector<ContourEdit::Shown> ContourEdit::shown() const {
  std::vector<Shown> all{{std::nullopt, outer_.is_closed(), outer_.steps()}};
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    if (islands_[i]) all.push_back({i, true, islands_[i]->steps()});
  }
  for (Shown& one : all) {
    for (Outline::Step& step : one.elements) {
      step.edge.from = told(step.edge.from);
      step.edge.to = told(step.edge.to);
    }
  }
  return all;
}

// As contours are told: of a lathe the radius is a diameter.
Vec2 ContourEdit::told(Vec2 point) const {
  return turns_ ? Vec2{point.u, point.v / kRadiusOfDiameter} : point;
}

Editing<LayerContours> ContourEdit::finished() const {
  std::vector<MadeContour> made{{&outer_, outer_.steps()}};
  for (const auto& island : islands_) {
    if (island) made.push_back({&*island, island->steps()});
  }
  auto sound = check_area(made);
  if (sound) sound = check_closed(made);
  if (sound) sound = check_apart(made, AxisNames{turns_});
  if (!sound) {
    EditFault fault = std::move(sound.error());
    if (fault.at) fault.at = told(*fault.at);
    return tl::make_unexpected(std::move(fault));
  }
  const auto finished = [&](const MadeContour& one) {
    return in_measure(normal_form(bridged(one)), turns_ ? 1 / kRadiusOfDiameter : 1);
  };
  LayerContours contours{finished(made.front()), {}};
  for (std::size_t i = 1; i < made.size(); ++i) contours.islands.push_back(finished(made[i]));
  return contours;
}

}  // namespace kerf::features
