#pragma once

#include <optional>
#include <string_view>

#include "drawing/canvas.hpp"
#include "drawing/svg/internal/lengths.hpp"
#include "drawing/svg/internal/tree.hpp"

namespace kerf::drawing::svg {

/// The part of an element's plane that fills its viewport.
struct ViewBox {
  Vec2 corner;
  Vec2 size;  ///< > 0
};
/// None: it is not four numbers with a size above 0.
[[nodiscard]] std::optional<ViewBox> view_box_of(std::string_view text);

/// How a view box lies in a viewport of another aspect.
struct Aspect {
  bool is_kept = true;    ///< `none`: stretched
  Vec2 share{0.5, 0.5};   ///< of what is left over: xMin, xMid, xMax
  bool is_slice = false;  ///< all of the viewport is covered
};
/// Of preserveAspectRatio; what is no value of it means xMidYMid meet.
[[nodiscard]] Aspect aspect_of(std::string_view text);

/// From the view box to a viewport of `size` at (0, 0).
[[nodiscard]] Affine fitted(const ViewBox& box, Vec2 size, const Aspect& aspect);

/// The root element on its page.
struct Page {
  Affine to_mm;   ///< Y up, zero at the lower left corner
  Vec2 viewport;  ///< of the root's user units; percents are of it
  double dpi = 96;
};

/// Reads size and units of the root; tells what was assumed, and in the canvas's facts what says
/// so. A drawing without any size has its zero where its own is.
[[nodiscard]] Page page_of(const Tree& tree, Canvas& canvas);

}  // namespace kerf::drawing::svg
