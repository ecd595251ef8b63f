#pragma once

#include <string>

#include "output/features/feature_facts.hpp"

namespace kerf::output {

/// The tree as an SVG document: a group a feature and hole, its id and class as the tree has them,
/// with the regions of its layers, what a drawing would say, and the way of the tool. 1 unit is
/// 1 mm, and Y points up by the one transform of the group "part"; set-ups lie side by side. Of a
/// lathe the half section: Z to the right, X (as a radius) up.
[[nodiscard]] std::string features_svg(const FeatureFacts& facts);

}  // namespace kerf::output
