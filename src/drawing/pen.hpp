#pragma once

#include <span>
#include <vector>

#include "drawing/affine.hpp"
#include "drawing/canvas.hpp"
#include "drawing/fit.hpp"
#include "drawing/round_path.hpp"

namespace kerf::drawing {

/// An ellipse by two half axes that are conjugate (of a circle: square and equally long):
/// centre + cos(t) first + sin(t) second.
struct Ellipse {
  Vec2 centre;
  Vec2 first;
  Vec2 second;
};

/// A point of a rational curve: where it is, and how much it weighs (> 0).
struct Weighted {
  Vec2 at;
  double weight = 1;
};

/// Draws the paths of one entity in coordinates of its own, which `to_mm` brings to those of the
/// drawing. Lines and arcs stay what they are, arcs under an unequal scale and all other curves
/// become lines and arcs that are no farther from them than Reading::tolerance_mm, everywhere, with
/// their ends and tangents (fit.hpp). A path ends with the next begin(), with close(), or with the
/// pen.
class Pen {
 public:
  Pen(Canvas& canvas, EntityId entity, const Affine& to_mm);
  ~Pen() { end(); }
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  void begin(Vec2 at);
  void line_to(Vec2 to);
  /// An arc whose bulge (contour::Edge) is that of the entity's own plane.
  void bulge_to(Vec2 to, double bulge);
  /// Along an ellipse from the parameter `from_rad` on by `sweep_rad`, at most a whole turn either
  /// way. A path that is begun is led to its first point by a line, where it is not there (within
  /// kStraight_mm); otherwise it begins there.
  void ellipse(const Ellipse& ellipse, double from_rad, double sweep_rad);
  /// The end of what was drawn last is known better than it was computed: it is here.
  void end_at(Vec2 exactly);
  /// A whole circle or ellipse as a closed path of its own.
  void whole(const Ellipse& ellipse);
  /// In mm about the drawing's zero, whatever to_mm is; the pen stands where it begins.
  void polar_to(const Polar& curve);
  void quadratic_to(Vec2 control, Vec2 to);
  void cubic_to(Vec2 first, Vec2 second, Vec2 to);
  /// A rational Bezier curve of the degree `rest.size()`, 1 to 10, that begins where the pen stands
  /// with the weight `weight`.
  void rational_to(double weight, std::span<const Weighted> rest);
  /// Back to the beginning, by a line where the pen is not there. Where curves alone were drawn,
  /// and what became of them lies on one circle within a tenth of the tolerance, bounds counted,
  /// that circle is drawn, as two halves.
  void close();
  void end();

  [[nodiscard]] bool has_begun() const { return has_begun_; }
  /// In the entity's own plane.
  [[nodiscard]] Vec2 at() const { return at_; }

 private:
  void start_where(Vec2 point);
  bool leads_away(std::span<const Vec2> points_mm);
  void forget();
  void make_circle();
  void go_on(Vec2 to_mm, double bulge);
  template <typename FitIt>
  void draw(FitIt&& fit_it);
  void take_fitted(const Step& step);

  Canvas& canvas_;
  EntityId entity_;
  Affine to_mm_;
  double mirror_;  // -1: bulges change their sign
  bool keeps_circles_;
  Vec2 at_;
  Vec2 begin_;
  bool has_begun_ = false;
  std::size_t fitted_at_ = 0;  ///< the vertex that a fitted edge ends in; 0: none
  Curves curves_;
  std::vector<contour::Vertex> vertices_;
  std::vector<Step> steps_;
};

}  // namespace kerf::drawing
