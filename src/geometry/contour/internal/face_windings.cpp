#include "geometry/contour/internal/face_windings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/contour/box_tree.hpp"

namespace kerf::contour {
namespace {

using Face = PlanarMap::Face;
using HalfEdge = PlanarMap::HalfEdge;

// What hangs together, beginning with the point farthest to the left: nothing of it lies on the
// left of that.
struct Component {
  PointId leftmost = 0;
  std::uint32_t first = 0;  ///< of its faces in the order in which they are found
  std::uint32_t count = 0;
};

class Numbering {
 public:
  explicit Numbering(const PlanarMap& map) : map_(map), is_known_(map.face_count(), false) {
    result_.of_face.resize(map.face_count());
  }

  FaceWindings run() {
    for (Face face = 0; face < map_.face_count(); ++face) {
      if (!is_known_[face]) spread_from(face);
    }
    std::sort(components_.begin(), components_.end(), [&](const Component& a, const Component& b) {
      return is_left_of(a.leftmost, b.leftmost);
    });
    measure();
    for (const Component& component : components_) place(component);
    return std::move(result_);
  }

 private:
  void spread_from(Face seed) {
    Component component{map_.origin(map_.beginning(seed)),
                        static_cast<std::uint32_t>(found_.size()), 0};
    know(seed, {});
    for (std::size_t i = component.first; i < found_.size(); ++i) spread(found_[i], component);
    component.count = static_cast<std::uint32_t>(found_.size()) - component.first;
    components_.push_back(component);
  }

  void know(Face face, Winding winding) {
    is_known_[face] = true;
    result_.of_face[face] = winding;
    found_.push_back(face);
  }

  void spread(Face face, Component& component) {
    const Winding here = result_.of_face[face];
    const HalfEdge beginning = map_.beginning(face);
    HalfEdge h = beginning;
    do {
      if (is_left_of(map_.origin(h), component.leftmost)) component.leftmost = map_.origin(h);
      const Face other = map_.face(PlanarMap::twin(h));
      const Winding there = here - map_.step(h);
      if (!is_known_[other]) {
        know(other, there);
      } else if (!(result_.of_face[other] == there)) {
        result_.agree = false;
      }
      h = map_.next(h);
    } while (h != beginning);
  }

  bool is_left_of(PointId a, PointId b) const {
    const Vec2 p = map_.point(a);
    const Vec2 q = map_.point(b);
    return p.u < q.u || (p.u == q.u && p.v < q.v);
  }

  // The last half-edge before the direction -x has the face around the component on its left.
  void place(const Component& component) {
    const Face around = map_.face(map_.ring(component.leftmost).back());
    const Winding outside =
        components_.size() > 1 ? winding_left_of(map_.point(component.leftmost)) : Winding{};
    const Winding shift = outside - result_.of_face[around];
    if (shift == Winding{}) return;
    for (std::uint32_t i = component.first; i < component.first + component.count; ++i) {
      result_.of_face[found_[i]] = result_.of_face[found_[i]] + shift;
    }
  }

  // What is next on the left of the point has the same face on its right. Windings there are known:
  // it belongs to a component that begins farther to the left.
  Winding winding_left_of(Vec2 point) {
    for (double reach = first_reach_;; reach *= 4) {
      const double end = std::max(point.u - reach, extents_.low.u - 1);
      const Next next = next_on_left(point, end);
      if (next.is_doubtful) return passed_on_left(point);
      if (next.piece != kNone) return result_.of_face[map_.face(rightward_of(next.piece))];
      if (end < extents_.low.u) return {};
    }
  }

  struct Next {
    std::uint32_t piece = kNone;
    double at = 0;
    bool is_doubtful = false;  ///< two are so near to each other that rounding could change places
  };

  Next next_on_left(Vec2 point, double end) {
    Box ray;
    ray.take(Vec2{end, point.v});
    ray.take(point);
    Next next{kNone, end, false};
    tree().search(ray, [&](std::uint32_t i) {
      if (!passes_left_of(map_.pieces()[i], point)) return;
      const double at = map_.pieces()[i].u_at(point.v);
      if (at < next.at - kDoubt_mm) return;
      next.is_doubtful = next.piece != kNone && at < next.at + kDoubt_mm;
      next.piece = at > next.at || next.piece == kNone ? i : next.piece;
      next.at = std::max(at, next.at);
    });
    return next;
  }

  HalfEdge rightward_of(std::uint32_t piece) const {
    const bool rises = map_.pieces()[piece].from.v < map_.pieces()[piece].to.v;
    return 2 * piece + (rises ? 1 : 0);
  }

  // The sum of all that is passed from the point to the left. Pieces rise or fall throughout and
  // share the heights of their ends exactly, so none is counted twice and none forgotten.
  Winding passed_on_left(Vec2 point) {
    Box ray;
    ray.take(Vec2{-std::numeric_limits<double>::infinity(), point.v});
    ray.take(point);
    Winding sum;
    tree().search(ray, [&](std::uint32_t i) {
      const Piece& piece = map_.pieces()[i];
      if (!passes_left_of(piece, point)) return;
      sum = piece.from.v <= point.v ? sum - piece.passes : sum + piece.passes;
    });
    return sum;
  }

  static bool passes_left_of(const Piece& piece, Vec2 point) {
    if ((piece.from.v <= point.v) == (piece.to.v <= point.v)) return false;
    if (point.u <= std::min(piece.from.u, piece.to.u)) return false;
    if (point.u >= std::max(piece.from.u, piece.to.u)) return true;
    const double side = piece.side_of(piece.in_frame(point));
    return piece.from.v < piece.to.v ? side < 0 : side > 0;
  }

  const BoxTree& tree() {
    if (!tree_) {
      std::vector<Box> boxes;
      boxes.reserve(map_.pieces().size());
      for (const Piece& piece : map_.pieces()) boxes.push_back(piece.box());
      tree_.emplace(boxes);
    }
    return *tree_;
  }

  void measure() {
    for (const Piece& piece : map_.pieces()) extents_.take(piece.box());
    const double count = static_cast<double>(map_.pieces().size() + 1);
    first_reach_ = (extents_.high.u - extents_.low.u) / std::sqrt(count) + kDoubt_mm;
  }

  static constexpr std::uint32_t kNone = ~0U;
  static constexpr double kDoubt_mm = 1e-6;

  const PlanarMap& map_;
  FaceWindings result_;
  std::vector<bool> is_known_;
  std::vector<Face> found_;
  std::vector<Component> components_;
  std::optional<BoxTree> tree_;
  Box extents_;
  double first_reach_ = 0;
};

}  // namespace

FaceWindings face_windings(const PlanarMap& map) { return Numbering(map).run(); }

}  // namespace kerf::contour
