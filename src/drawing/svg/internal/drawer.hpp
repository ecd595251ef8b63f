#pragma once

#include <string>
#include <vector>

#include "drawing/canvas.hpp"
#include "drawing/svg/internal/page.hpp"
#include "drawing/svg/internal/shapes.hpp"
#include "drawing/svg/internal/style.hpp"
#include "drawing/svg/internal/texts.hpp"

namespace kerf::drawing::svg {

/// Goes through a tree and draws it, each clone where it is used.
class Drawer {
 public:
  /// All outlive this.
  Drawer(const Tree& tree, Canvas& canvas, const std::string& folder);

  void draw();

 private:
  /// What holds for an element from those around it, and then for it.
  struct Context {
    Affine to_mm;
    Vec2 viewport;
    Style style;
    Name layer{};  ///< of Inkscape; empty: its colour names it
    bool is_off = false;
    bool is_clone = false;
  };
  /// Where a nested viewport lies; what is not given is that of the element.
  struct Frame {
    std::optional<double> width;
    std::optional<double> height;
    Vec2 at;
  };

  void visit(ElementId id, const Context& around);
  void visit_children(ElementId id, const Context& context);
  void visit_first(ElementId id, const Context& context);
  void visit_clone(ElementId id, const Context& context);
  void visit_clone_of(ElementId target, const Context& context, const Frame& frame);
  void visit_viewport(ElementId id, const Context& context, const Frame& frame);
  void dispatch(ElementId id, const Context& context);
  [[nodiscard]] Context inside(ElementId id, const Context& around);
  void enter_layer(ElementId id, Context& context);
  [[nodiscard]] bool is_meant(ElementId id) const;
  [[nodiscard]] bool clones_itself(ElementId use, ElementId target) const;

  void draw_shape_of(ElementId id, const Context& context);
  void draw_text(ElementId id, const Context& context);
  void draw_words(const Words& words, const Context& context);
  void draw_picture(ElementId id, const Context& context);
  void place_picture(ElementId id, const Context& context, std::string bytes);

  [[nodiscard]] bool is_seen(ElementId id, const Context& context);
  [[nodiscard]] std::optional<Colour> colour(const Paint& paint, const Style& style);
  [[nodiscard]] std::optional<Colour> colour_of(ElementId id, const Style& style);
  [[nodiscard]] Name layer_of(const Context& context, Colour colour);
  [[nodiscard]] Entity entity_of(ElementId id, Name layer, Colour colour, const Style& style);
  [[nodiscard]] Name dashes_of(ElementId id, const Context& context);
  [[nodiscard]] Measures measures(const Context& context) const;

  void tell_left_out(ElementId id, const Context& context);
  void tell_paint(ElementId id, const Paint& paint);
  void tell_clipped(ElementId id, const Context& context, Vec2 low, Vec2 size, std::size_t first);
  void tell(base::Severity severity, base::Code code, ElementId id, const std::string& detail);
  void warn(base::Code code, ElementId id, const std::string& detail) {
    tell(base::Severity::warning, code, id, detail);
  }
  void ignore(ElementId id, const std::string& what, std::string_view why);

  const Tree& tree_;
  Canvas& canvas_;
  const std::string& folder_;
  StyleSheet sheet_;
  double dpi_ = 96;
  std::vector<ElementId> clones_;  ///< what is being cloned, from outside in
  std::size_t depth_ = 0;
  std::uint64_t picture_bytes_ = 0;
};

}  // namespace kerf::drawing::svg
