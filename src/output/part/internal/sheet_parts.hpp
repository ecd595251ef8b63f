#pragma once

#include <string>
#include <vector>

#include "output/part/internal/paints.hpp"
#include "output/part/part_picture.hpp"

namespace kerf::output::plot {

// What all pictures of a part have around it. Pixels.
inline constexpr double kSheetWidth = 1280;
inline constexpr double kSheetMargin = 32;
inline constexpr double kSheetInner = kSheetWidth - 2 * kSheetMargin;
inline constexpr double kPictureTop = 82;
inline constexpr double kRulerLeft = 54;
inline constexpr double kRulerBelow = 40;

/// Title and a line about it.
void draw_head(DisplayList& sheet, const PartScene& scene, const std::string& about);
/// Below the picture: tools with their colours, what the part came to, findings. Sets the height.
void draw_foot(DisplayList& sheet, double top, const PartScene& scene, const Paints& paints);

/// A finding with a place, as it is numbered in the picture and in the list.
struct Mark {
  std::size_t number = 0;
  const StockFacts::Told* told = nullptr;
};
/// Those that have a place, from 1 on, at most kMostMarks.
[[nodiscard]] std::vector<Mark> marks_of(const PartScene& scene);
inline constexpr std::size_t kMostMarks = 24;

/// A numbered disc; `center` and the place that it is about; dashed: that is hidden.
void draw_mark(DisplayList& sheet, const Mark& mark, Point place, Point center, bool is_hidden);
/// Discs beside their places, none on another.
struct PlacedMark {
  Mark mark;
  Point place;
  bool is_hidden = false;
};
void draw_marks(DisplayList& sheet, const std::vector<PlacedMark>& marks, const Rect& area);
[[nodiscard]] Color mark_color(const StockFacts::Told& told);

/// "1 234.5 mm³", as people write it.
[[nodiscard]] std::string volume_text(double mm3);
/// Three digits behind the point at most, none that says nothing.
[[nodiscard]] std::string short_number(double value, int digits = 3);

/// A bar of a round length, its right end at `right`.
void draw_scale_bar(DisplayList& sheet, Point right, double pixels_per_mm);

}  // namespace kerf::output::plot
