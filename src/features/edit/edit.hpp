#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::features {

// The operations of an edits file (features-contract §6). mm and degrees, coordinates of the part;
// of a lathe (z, x) with x a diameter, as contours are told. Elements and corners count from 0.

/// Another contour in its place, from any point and in either sense; `centre_line`: the open way
/// of a slot, a groove, an engraving.
struct ReplaceContour {
  std::optional<contour::Contour> contour{};
  std::optional<std::vector<contour::Contour>> islands{};
  std::optional<contour::Contour> centre_line{};
};
/// A new element, with the next free number.
struct AddElement {
  contour::Edge edge{};
};
/// What is not said stays; neighbours that were joined to an end follow it.
struct ModifyLine {
  std::size_t element = 0;
  std::optional<contour::Vec2> from{};
  std::optional<contour::Vec2> to{};
  std::optional<double> length{};
  std::optional<double> angle_deg{};
};
struct ModifyArc {
  std::size_t element = 0;
  std::optional<double> radius{};  ///< the ends stay
  std::optional<contour::Vec2> centre{};
  std::optional<double> start_deg{};
  std::optional<double> end_deg{};
  std::vector<contour::Vec2> through{};  ///< three points
};
/// Extends or trims both to their nearest common point.
struct JoinElements {
  std::size_t first = 0;
  std::size_t second = 0;
};
/// Of every corner of two lines where no corner is named.
struct ChamferCorner {
  std::optional<std::size_t> corner{};
  double before = 0;  ///< d1: along the element that leads to the corner
  double after = 0;   ///< d2
  /// Instead of d2: between the chamfer and the element that leads to the corner, two lines.
  std::optional<double> angle_deg{};
};
struct FilletCorner {
  std::optional<std::size_t> corner{};
  double radius = 0;
};
/// Leaves a gap.
struct DeleteElement {
  std::size_t element = 0;
};
struct AddIsland {
  contour::Contour contour{};
};
struct DeleteIsland {
  std::size_t island = 0;
};
/// Of all layers. `z`: of a lathe.
struct MoveFeature {
  double dx = 0;
  double dy = 0;
  double dz = 0;
};
struct RotateFeature {
  double deg = 0;
  std::optional<contour::Vec2> about{};
};
struct ScaleFeature {
  double factor = 1;
  std::optional<contour::Vec2> about{};
};
/// The bottom of a feature, a hole, all holes of a pattern.
struct SetDepth {
  std::optional<double> z{};
  std::optional<double> x{};  ///< of a groove, a diameter
};
struct DeleteFeature {};
struct MoveHole {
  contour::Vec2 to{};
};
struct AddHole {
  contour::Vec2 at{};
};
struct SetPeck {
  double depth = 0;  ///< Q
};
struct SetFeed {
  std::optional<double> cut{};
  std::optional<double> entry{};
};
struct SetTool {
  std::uint32_t tool = 0;
  bool split = false;  ///< the opening of its operation is copied
};
struct ChangeOrder {
  bool is_before = true;
  std::string other{};  ///< an id or a key
};
/// The literal of a call, or of a `#n=` of the main program.
struct SetArgument {
  std::string letter{};
  std::uint32_t variable = 0;  ///< where no letter is named
  double value = 0;
};
/// The loop or the call is written out.
struct Unroll {};

using EditOperation =
    std::variant<ReplaceContour, AddElement, ModifyLine, ModifyArc, JoinElements, ChamferCorner,
                 FilletCorner, DeleteElement, AddIsland, DeleteIsland, MoveFeature, RotateFeature,
                 ScaleFeature, SetDepth, DeleteFeature, MoveHole, AddHole, SetPeck, SetFeed,
                 SetTool, ChangeOrder, SetArgument, Unroll>;

/// How the layers that an edit does not name follow it.
enum class LayerRule : std::uint8_t {
  rebuild,  ///< above: united with the new removal; below: intersected with it
  all,
  only,
};
/// What is edited of blocks that several calls run.
enum class EditScope : std::uint8_t { unsaid, all, this_call };

/// One edit of a file.
struct Edit {
  EditOperation operation{};
  std::string target{};                 ///< id or key of a feature, a hole, a pattern, a call
  std::optional<std::size_t> layer{};   ///< from 1
  std::optional<std::size_t> island{};  ///< from 0; none: the outer contour
  LayerRule layers = LayerRule::rebuild;
  EditScope scope = EditScope::unsaid;
  bool unrolls = false;
  std::uint32_t line = 0;  ///< of the edits file, where it begins; from 1
  std::uint32_t column = 0;
};

}  // namespace kerf::features
