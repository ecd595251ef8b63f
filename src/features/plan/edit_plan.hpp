#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "features/edit/contour_edit.hpp"
#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/rewrite/planned_row.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// A layer whose contour an edit changes, as it shall come back.
struct WantedLayer {
  std::size_t feature = 0;
  std::size_t layer = 0;  ///< behind the last one: a layer that comes in
  LayerContours contours{};
  double z = 0;
  std::optional<std::uint32_t> tool{};  ///< another one than before
  contour::Region stays{};              ///< of what the tool could reach, between ends of passes
};

/// An operation that another tool shall cut: T, H and D of its opening become another number.
struct ToolChange {
  std::uint32_t was = 0;
  std::uint32_t is = 0;
  Span rows{};  ///< of the operation
};

/// A turned feature as it shall come back; contour (z, radius), open.
struct WantedTurned {
  std::size_t feature = 0;
  std::optional<contour::Contour> contour{};  ///< none: its depth alone is another
};

/// A hole as it shall come back.
struct WantedHole {
  contour::Vec2 at{};
  double bottom = 0;
  std::optional<double> peck{};
  std::size_t like = 0;  ///< the hole that it was, or is made like
};

/// What edits make of the rows of a program.
struct EditPlan {
  RowPlan rows{};
  /// Layers of edited features that are cut anew, moved or deepened; all else stays.
  std::vector<WantedLayer> wanted{};
  std::vector<std::pair<std::size_t, std::size_t>> gone{};  ///< feature and layer
  std::vector<ToolChange> tools{};
  std::vector<std::size_t> edited_holes{};
  std::vector<WantedHole> wanted_holes{};
  std::vector<std::size_t> gone_holes{};  ///< they are among the edited ones, too
  std::vector<WantedTurned> turned{};
  std::vector<std::size_t> arguments{};  ///< edits of the file that change an argument
  bool changes_more = false;             ///< blocks of several features, or what a call cuts
  std::vector<EditFault> warnings{};
  /// The recording as its blocks command it, if rows are planned in that; none: as it is.
  std::shared_ptr<const Recording> programmed{};
};

}  // namespace kerf::features
