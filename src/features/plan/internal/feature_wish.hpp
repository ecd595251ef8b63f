#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "features/edit/contour_edit.hpp"
#include "features/edit/edit.hpp"
#include "features/path/move.hpp"

namespace kerf::features {

/// What all edits of a file make of one feature of a mill. Its blocks are changed once, when all
/// of them are known.
struct FeatureWish {
  std::map<std::size_t, ContourEdit> layers{};  ///< as moved by `by`
  std::map<std::size_t, LayerRule> rules{};     ///< of layers whose contours are edited
  Vec3 by{};                                    ///< the feature as a whole
  std::optional<double> bottom{};               ///< before it is moved
  bool goes = false;
  SetFeed feed{};
  std::optional<std::uint32_t> tool{};
  /// Ways of the one pass of layers, as moved by `by`.
  std::map<std::size_t, contour::Contour> centre_lines{};
  std::size_t edit = 0;  ///< the last one that names it
};

/// Likewise of a hole. Its place, depth, feed and peck are those that it shall have.
struct HoleWish {
  std::optional<contour::Vec2> to{};
  std::optional<double> bottom{};
  std::optional<double> feed{};
  std::optional<double> peck{};
  std::vector<contour::Vec2> added{};  ///< behind it in its list
  std::optional<std::uint32_t> tool{};
  bool goes = false;
  std::size_t edit = 0;

  [[nodiscard]] bool changes_rows() const {
    return to || bottom || feed || peck || tool || !added.empty();
  }
};

/// Of all features and holes that edits name, by their place in the tree.
struct EditWishes {
  std::map<std::size_t, FeatureWish> features{};
  std::map<std::size_t, HoleWish> holes{};
};

}  // namespace kerf::features
