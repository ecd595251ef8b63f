#pragma once

#include "job/features_run.hpp"
#include "output/features/feature_facts.hpp"

namespace kerf::job {

/// What was recognised, for reports: it points into the result, which still has its run.
[[nodiscard]] output::FeatureFacts facts_of(FeaturesResult& result);

}  // namespace kerf::job
