#pragma once

#include <vector>

#include "features/milling/draft.hpp"
#include "features/milling/material.hpp"

namespace kerf::features {

/// What there is to know for the type of a feature besides itself.
struct Neighbourhood {
  const Recording& recording;
  const Material& material;          ///< of its set-up, all cuts done
  const std::vector<Draft>& drafts;  ///< in order
  std::size_t place = 0;             ///< of the feature among them
  contour::Box all{};                ///< around all that was cut in the set-up
  bool is_first_operation = false;
  bool has_others_later = false;  ///< something else is cut by later operations
};

/// The first type that fits, with its measures; reasons go to the feature.
void classify(const Neighbourhood& around, Draft& draft);

}  // namespace kerf::features
