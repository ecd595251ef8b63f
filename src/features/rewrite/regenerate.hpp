#pragma once

#include <cstddef>
#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "features/rewrite/cannot_cut.hpp"
#include "features/rewrite/old_ways.hpp"
#include "features/rewrite/planned_row.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// A layer as it shall be: contours as they are edited (nominal).
struct NewLayer {
  const Feature* feature = nullptr;
  std::size_t layer = 0;  ///< its place in the feature
  contour::Contour outer{};
  std::vector<contour::Contour> islands{};
  bool allows_rest = false;  ///< material that the tool could reach may stay
  double new_radius = 0;     ///< of another tool that shall cut it; 0: the one that did
  /// The way of one pass; null: the outline says it.
  const contour::Contour* centre_line = nullptr;
};

/// What a layer that is cut anew becomes.
struct NewRows {
  Stretch stretch{};
  std::optional<CannotCut> left{};  ///< what would refuse it, and is allowed
  /// What the tool could reach and its passes leave, as the old ones did: between their ends.
  contour::Region stays{};
};

/// Whether the contour of a feature bounds what stands, not what is removed.
[[nodiscard]] bool bounds_what_stands(const Feature& feature);

/// The rows of a layer of closed loops for its new contours: loops at the distances, in the order,
/// the direction and with the entries that the old ones had (features-contract §7). Rows that stay
/// what they were keep their blocks.
[[nodiscard]] tl::expected<NewRows, CannotCut> regenerated(const Recording& recording,
                                                           OldWays& ways, const NewLayer& wanted);

/// The rows that belong to a layer from its approach to its retract: the last rapid across that
/// comes before its first cut included.
[[nodiscard]] Span whole_visit(const Recording& recording, const Layer& layer);

}  // namespace kerf::features
