#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kerf::output::plot {

/// On the sheet: to the right and down from its upper left corner. The unit is a pixel of the SVG.
struct Point {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

struct Rect {
  double left = 0, top = 0, width = 0, height = 0;
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
  [[nodiscard]] Point center() const { return {left + width / 2, top + height / 2}; }
  [[nodiscard]] Rect shrunk(double by) const {
    return {left + by, top + by, width - 2 * by, height - 2 * by};
  }
};

struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;
};

/// Lines and cubic Bezier curves: steps, and the points that they take (1, 1, 3, 0). After a close
/// comes a move or nothing.
struct Outline {
  enum class Step : std::uint8_t { move, line, curve, close };
  std::vector<Step> steps;
  std::vector<Point> points;

  [[nodiscard]] bool empty() const { return steps.empty(); }
  void move_to(Point to) { add(Step::move, to); }
  void line_to(Point to) { add(Step::line, to); }
  void curve_to(Point control1, Point control2, Point to) {
    points.push_back(control1);
    points.push_back(control2);
    add(Step::curve, to);
  }
  void close() { steps.push_back(Step::close); }

  void segment(Point from, Point to) {
    move_to(from);
    line_to(to);
  }
  void rectangle(const Rect& rect);
  void circle(Point center, double radius);

 private:
  void add(Step step, Point to) {
    steps.push_back(step);
    points.push_back(to);
  }
};

/// How an outline is drawn: filled, then stroked with round ends and corners.
struct Ink {
  std::optional<Color> stroke;
  double width = 1;
  bool dashed = false;
  std::optional<Color> fill;
};

inline constexpr double kDashOn = 5, kDashOff = 4;

struct Shape {
  Outline outline;
  Ink ink;
};

enum class Anchor : std::uint8_t { start, middle, end };

/// One line of UTF-8 text without control characters. `at` is on the base line; a halo keeps it
/// legible on top of lines.
struct Text {
  Point at;
  std::string text;
  double size = 12;
  Anchor anchor = Anchor::start;
  Color color{};
  bool bold = false;
  bool halo = false;
};

/// Pixels in a place of the sheet, in whose shape they are.
struct Image {
  Rect at;
  int width = 0;
  int height = 0;
  std::string rgb;  ///< three bytes a pixel, by rows from above
};

/// A drawing on a white sheet: what comes later lies on top.
struct DisplayList {
  double width = 0, height = 0;
  std::string title;
  std::vector<std::variant<Shape, Text, Image>> items;

  /// Empty outlines are left out.
  void add(Outline outline, const Ink& ink) {
    if (!outline.empty()) items.push_back(Shape{std::move(outline), ink});
  }
  void add(Text text) { items.push_back(std::move(text)); }
  void add(Image image) { items.push_back(std::move(image)); }
};

}  // namespace kerf::output::plot
