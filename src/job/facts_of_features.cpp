#include "job/facts_of_features.hpp"

#include "job/facts_of_run.hpp"

namespace kerf::job {
namespace {

std::string word_of(const stock::Workpiece& shape, bool turns) {
  if (std::holds_alternative<stock::BoxShape>(shape)) return "box";
  if (std::holds_alternative<stock::MeshShape>(shape)) return "mesh";
  return turns ? "bar" : "cylinder";
}

}  // namespace

output::FeatureFacts facts_of(FeaturesResult& result) {
  output::FeatureFacts facts;
  facts.run = facts_of(result.run->machine());
  facts.run.assumed.insert(facts.run.assumed.end(), result.assumed.begin(), result.assumed.end());
  if (result.shape) {
    facts.blank = {.shape = word_of(*result.shape, result.recording.turns),
                   .is_assumed = !result.knows_stock,
                   .extents = stock::bounds(*result.shape)};
  }
  facts.recording = &result.recording;
  facts.tree = &result.tree;
  facts.sources = &result.run->machine().sources();
  return facts;
}

}  // namespace kerf::job
