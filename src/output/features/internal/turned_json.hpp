#pragma once

#include "output/features/feature_facts.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {

/// The members that features of a lathe have besides the common ones. X are diameters.
void add_turned(const FeatureFacts& facts, const features::Feature& feature, JsonObject& object);

/// A turned contour with diameters: [[z, x, bulge]…], the bulges those of the true arcs.
[[nodiscard]] std::string diameters_json(const contour::Contour& contour);

}  // namespace kerf::output
