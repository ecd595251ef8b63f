#pragma once

#include <vector>

#include "features/tree/feature.hpp"
#include "features/turning/chains.hpp"
#include "features/turning/reach.hpp"

namespace kerf::features {

/// A chain with what it did.
struct TurnedChain {
  Chain chain{};
  std::size_t operation = 0;
  Beyond beyond = Beyond::outside;
  TipWidth width{};
  Nose nose{};
  contour::Region removed{};  ///< of the material that was there
  contour::Box path{};        ///< around the tool's point
};

/// A feature of a lathe while its chains come in.
struct TurnedDraft {
  Feature feature{};
  contour::Region removed{};
  std::vector<TurnedChain> chains{};

  /// Whether a chain goes on where this one has cut: beside it, or over it once more.
  [[nodiscard]] bool meets(const TurnedChain& more) const;
  void add(TurnedChain more);
};

/// Draws the sum: contour, elements, passes, measures, cuts.
void finish(const Recording& recording, TurnedDraft& draft);

}  // namespace kerf::features
