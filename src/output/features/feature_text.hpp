#pragma once

#include <string>

#include "output/features/feature_facts.hpp"

namespace kerf::output {

/// The tree for people, a node a line: set-ups, their operations, the features and holes of these.
/// What is doubtful ends in a question mark and the reasons.
[[nodiscard]] std::string features_text(const FeatureFacts& facts);

/// The line of a feature or hole, without its place in the tree.
[[nodiscard]] std::string feature_title(const FeatureFacts& facts, std::size_t place);
[[nodiscard]] std::string hole_title(const FeatureFacts& facts, std::size_t place);

}  // namespace kerf::output
