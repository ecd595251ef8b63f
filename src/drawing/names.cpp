#include "drawing/names.hpp"

namespace kerf::drawing {

Name Names::find(std::string_view text) {
  if (const auto known = numbers_.find(text); known != numbers_.end()) return known->second;
  const Name next{static_cast<std::uint32_t>(texts_.size())};
  texts_.emplace_back(text);
  numbers_.emplace(texts_.back(), next);
  return next;
}

}  // namespace kerf::drawing
