#pragma once

#include <string>

#include "output/features/feature_facts.hpp"

namespace kerf::output {

// Members of the tree of features, each as JSON.

[[nodiscard]] std::string feature_json(const FeatureFacts& facts, std::size_t place);
[[nodiscard]] std::string step_json(const FeatureFacts& facts, const features::HoleStep& step);
[[nodiscard]] std::string hole_json(const FeatureFacts& facts, std::size_t place);
[[nodiscard]] std::string pattern_json(const FeatureFacts& facts, std::size_t place);
[[nodiscard]] std::string call_json(const FeatureFacts& facts, std::size_t place);
[[nodiscard]] std::string literal_json(const FeatureFacts& facts);
[[nodiscard]] std::string parent_json(const std::optional<features::Relation>& parent);
[[nodiscard]] std::string origin_json(const features::Origin& origin);
[[nodiscard]] std::string reasons_json(const std::vector<features::Reason>& reasons);
/// [first, last] of all of them together.
[[nodiscard]] std::string lines_json(const FeatureFacts& facts,
                                     const std::vector<features::Span>& spans);
/// A word as a JSON string.
[[nodiscard]] std::string word_json(std::string_view word);

}  // namespace kerf::output
