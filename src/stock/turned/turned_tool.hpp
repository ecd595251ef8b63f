#pragma once

#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/sweep/body.hpp"

namespace kerf::stock::turned {

/// A tool in the plane (u = Z, v = X) with its tip at 0, 0: an insert as its outline, a tool on the
/// axis as its section through both sides.
class TurnedTool {
 public:
  /// Something of the tool, and what of it may not meet material: Body::touch_mm less on all sides.
  struct Part {
    ToolPart part = ToolPart::edge;
    contour::Region whole;
    contour::Region shrunk;
    contour::Box box;        ///< of the whole
    bool is_convex = false;  ///< both, one loop each
  };

  explicit TurnedTool(const Body& body);

  /// What removes material: the insert, or all that the edges of a tool on the axis go round.
  [[nodiscard]] const Part& cutter() const { return cutter_; }
  /// The edges of an insert that cut; none: all of them do. The others are its back.
  [[nodiscard]] const std::vector<contour::Edge>& edges() const { return edges_; }
  [[nodiscard]] const std::vector<contour::Edge>& back() const { return back_; }
  /// What never cuts; of an insert its holder.
  [[nodiscard]] const std::vector<Part>& others() const { return others_; }

  [[nodiscard]] bool is_insert() const { return is_insert_; }
  /// An insert stands on the far side of the tip from the axis.
  [[nodiscard]] bool is_outside() const { return cutter_.box.middle().v > 0; }
  [[nodiscard]] bool cuts() const { return cuts_; }
  [[nodiscard]] double touch_mm() const { return touch_mm_; }

 private:
  void take_insert(const Insert& insert);
  void take_profile(const Profile& profile);
  [[nodiscard]] Part part_of(ToolPart part, contour::Region region) const;
  void add_other(ToolPart part, contour::Region region);

  Part cutter_;
  std::vector<contour::Edge> edges_;
  std::vector<contour::Edge> back_;
  std::vector<Part> others_;
  bool is_insert_ = false;
  bool cuts_ = true;
  double touch_mm_ = 0;
};

}  // namespace kerf::stock::turned
