#include "features/edit/outline.hpp"

#include <utility>

#include "features/edit/internal/drawn_elements.hpp"
#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Edge;
using contour::Vec2;

constexpr std::size_t kNone = ~std::size_t{0};
constexpr double kNoElement_mm = 1e-7;  // shorter than that: the normal form has no such edge

std::optional<std::size_t> number(std::size_t link) {
  return link == kNone ? std::nullopt : std::optional{link};
}

}  // namespace

Outline::Outline(const contour::Contour& contour, std::string owner)
    : is_closed_(contour.is_closed), owner_(std::move(owner)) {
  const std::size_t count = contour::edge_count(contour);
  for (std::size_t i = 0; i < count; ++i) {
    edges_.emplace_back(contour::edge_of(contour, i));
    elements_.push_back({i == 0 ? kNone : i - 1, i + 1 == count ? kNone : i + 1});
  }
  first_ = count == 0 ? kNone : 0;
  if (is_closed_ && count > 0) link(count - 1, 0);
}

const Edge* Outline::find(std::size_t element) const {
  return element < edges_.size() && edges_[element] ? &*edges_[element] : nullptr;
}

std::optional<std::size_t> Outline::after(std::size_t element) const {
  return number(elements_[element].after);
}

std::optional<std::size_t> Outline::before(std::size_t element) const {
  return number(elements_[element].before);
}

bool Outline::is_drawn(std::size_t element) const { return elements_[element].is_drawn; }

Vec2 Outline::point(End end) const {
  const Edge& edge = *edges_[end.element];
  return end.is_start ? edge.from : edge.to;
}

bool Outline::is_at(End end, Vec2 point) const {
  return geometry::length(this->point(end) - point) <= kSamePoint_mm;
}

std::optional<Outline::End> Outline::neighbour_at(End end) const {
  const std::size_t other =
      end.is_start ? elements_[end.element].before : elements_[end.element].after;
  if (other == kNone || other == end.element) return std::nullopt;
  const End met{other, !end.is_start};
  return is_at(met, point(end)) ? std::optional{met} : std::nullopt;
}

std::optional<Outline::End> Outline::drawn_at(Vec2 point, std::size_t but) const {
  for (const std::size_t element : drawn_) {
    if (element == but || !edges_[element]) continue;
    for (const bool is_start : {true, false}) {
      if (is_at({element, is_start}, point)) return End{element, is_start};
    }
  }
  return std::nullopt;
}

std::optional<Outline::End> Outline::any_at(Vec2 point, std::size_t but) const {
  for (std::size_t element = 0; element < edges_.size(); ++element) {
    if (element == but || !edges_[element]) continue;
    for (const bool is_start : {true, false}) {
      if (is_at({element, is_start}, point)) return End{element, is_start};
    }
  }
  return std::nullopt;
}

std::optional<Outline::End> Outline::joined(End end) const {
  if (is_drawn(end.element)) return any_at(point(end), end.element);
  if (const auto neighbour = neighbour_at(end)) return neighbour;
  return drawn_at(point(end), end.element);
}

void Outline::link(std::size_t first, std::size_t second) {
  if (first != kNone) elements_[first].after = second;
  if (second != kNone) elements_[second].before = first;
}

std::size_t Outline::add(const Edge& edge) {
  edges_.emplace_back(edge);
  elements_.push_back({kNone, kNone, true});
  drawn_.push_back(edges_.size() - 1);
  return edges_.size() - 1;
}

std::size_t Outline::insert_after(std::size_t element, const Edge& edge) {
  if (is_drawn(element)) return add(edge);
  const std::size_t behind = elements_[element].after;
  const std::size_t inserted = edges_.size();
  edges_.emplace_back(edge);
  elements_.push_back({});
  link(element, inserted);
  link(inserted, behind);
  return inserted;
}

void Outline::set(std::size_t element, const Edge& edge) {
  edges_[element] = edge;
  if (contour::length(edge) < kNoElement_mm) remove(element);
}

void Outline::move_end(End end, Vec2 to) {
  Edge edge = *edges_[end.element];
  (end.is_start ? edge.from : edge.to) = to;
  set(end.element, edge);
}

void Outline::remove(std::size_t element) {
  edges_[element].reset();
  if (is_drawn(element)) return;
  const Element gone = elements_[element];
  if (first_ == element) first_ = gone.after == element ? kNone : gone.after;
  if (gone.after != element) link(gone.before, gone.after);
}

std::vector<Outline::Step> Outline::steps() const {
  std::vector<Step> placed;
  for (std::size_t element = first_; element != kNone; element = elements_[element].after) {
    placed.push_back({element, *edges_[element]});
    if (elements_[element].after == first_) break;
  }
  std::vector<Step> drawn;
  for (const std::size_t element : drawn_) {
    if (edges_[element]) drawn.push_back({element, *edges_[element]});
  }
  return with_drawn(std::move(placed), drawn, is_closed_);
}

}  // namespace kerf::features
