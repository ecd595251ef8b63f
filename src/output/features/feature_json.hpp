#pragma once

#include <string>

#include "output/features/feature_facts.hpp"

namespace kerf::output {

/// The tree as one JSON object with a line end behind it.
[[nodiscard]] std::string features_json(const FeatureFacts& facts);

/// Its member `unrecognised`.
[[nodiscard]] std::string unrecognised_json(const FeatureFacts& facts);

}  // namespace kerf::output
