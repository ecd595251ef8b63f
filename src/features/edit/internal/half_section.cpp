#include "features/edit/internal/half_section.hpp"

#include <optional>
#include <vector>

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Vec2;

class Measure {
 public:
  explicit Measure(double times) : times_(times) {}

  void take(Vec2& point) const { point.v *= times_; }
  void take(Contour& contour) const {
    for (contour::Vertex& vertex : contour.vertices) take(vertex.point);
  }
  template <typename T>
  void take(std::optional<T>& value) const {
    if (value) take(*value);
  }
  template <typename T>
  void take(std::vector<T>& values) const {
    for (T& value : values) take(value);
  }

  void operator()(ReplaceContour& wish) const {
    take(wish.contour);
    take(wish.islands);
    take(wish.centre_line);
  }
  void operator()(AddElement& wish) const {
    take(wish.edge.from);
    take(wish.edge.to);
  }
  void operator()(ModifyLine& wish) const {
    take(wish.from);
    take(wish.to);
  }
  void operator()(ModifyArc& wish) const {
    take(wish.centre);
    take(wish.through);
  }
  void operator()(AddIsland& wish) const { take(wish.contour); }
  void operator()(MoveFeature& wish) const { wish.dx *= times_; }
  void operator()(RotateFeature& wish) const { take(wish.about); }
  void operator()(ScaleFeature& wish) const { take(wish.about); }
  // Lengths along contours and numbers of elements are what they are.
  template <typename Other>
  void operator()(Other&) const {}

 private:
  double times_ = 1;
};

}  // namespace

EditOperation in_measure(EditOperation operation, double times) {
  std::visit(Measure(times), operation);
  return operation;
}

Contour in_measure(Contour contour, double times) {
  Measure(times).take(contour);
  return contour;
}

}  // namespace kerf::features
