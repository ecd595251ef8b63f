#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// One contour while it is edited. Its elements have numbers that stay; one that is deleted leaves
/// a gap, one that comes in has the next free number. Between two edits it may be open, or cross
/// itself.
class Outline {
 public:
  /// Elements are the edges in their order. `owner`: behind ELEMENT in sentences, " OF ISLAND 1".
  explicit Outline(const contour::Contour& contour, std::string owner = {});

  /// An end of an element.
  struct End {
    std::size_t element = 0;
    bool is_start = true;
  };
  /// An element where it stands along the contour; `edge` is turned round if it was drawn against
  /// it.
  struct Step {
    std::size_t element = 0;
    contour::Edge edge{};
  };

  [[nodiscard]] bool is_closed() const { return is_closed_; }
  [[nodiscard]] const std::string& owner() const { return owner_; }

  /// Nothing: there is no such element, or no longer.
  [[nodiscard]] const contour::Edge* find(std::size_t element) const;
  /// One more than the last number.
  [[nodiscard]] std::size_t size() const { return edges_.size(); }
  /// The element of the contour behind this one; of the last one of an open contour, and of one
  /// that was drawn, nothing.
  [[nodiscard]] std::optional<std::size_t> after(std::size_t element) const;
  [[nodiscard]] std::optional<std::size_t> before(std::size_t element) const;
  /// True: add() brought it, and it has no place along the contour yet.
  [[nodiscard]] bool is_drawn(std::size_t element) const;

  [[nodiscard]] contour::Vec2 point(End end) const;
  /// The end of another element that is where this one is.
  [[nodiscard]] std::optional<End> joined(End end) const;

  /// One that has its place by where its ends are.
  std::size_t add(const contour::Edge& edge);
  /// Between an element and the one behind it; beside one that was drawn as add().
  std::size_t insert_after(std::size_t element, const contour::Edge& edge);
  /// What is too short to be an element is deleted.
  void set(std::size_t element, const contour::Edge& edge);
  void move_end(End end, contour::Vec2 to);
  void remove(std::size_t element);
  /// All points by `moved`, an affine map that keeps circles.
  template <typename Map>
  void move_all(Map&& moved) {
    for (auto& edge : edges_) {
      if (!edge) continue;
      edge->from = moved(edge->from);
      edge->to = moved(edge->to);
    }
  }

  /// All elements along the contour. Those that were drawn stand, one after the other, each in the
  /// gap that it makes smallest.
  [[nodiscard]] std::vector<Step> steps() const;

 private:
  struct Element {
    std::size_t before = 0;
    std::size_t after = 0;
    bool is_drawn = false;
  };

  void link(std::size_t first, std::size_t second);
  [[nodiscard]] bool is_at(End end, contour::Vec2 point) const;
  [[nodiscard]] std::optional<End> drawn_at(contour::Vec2 point, std::size_t but) const;
  [[nodiscard]] std::optional<End> neighbour_at(End end) const;
  [[nodiscard]] std::optional<End> any_at(contour::Vec2 point, std::size_t but) const;

  std::vector<std::optional<contour::Edge>> edges_;
  std::vector<Element> elements_;   // by number, as edges_
  std::vector<std::size_t> drawn_;  // numbers of those that add() brought
  std::size_t first_ = 0;           // of those that have their place; kNone: there are none
  bool is_closed_ = true;
  std::string owner_;
};

}  // namespace kerf::features
