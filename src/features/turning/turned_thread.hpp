#pragma once

#include "features/turning/half_section.hpp"
#include "features/turning/turned_draft.hpp"

namespace kerf::features {

/// Whether a chain cuts the thread of a draft once more.
[[nodiscard]] bool is_same_thread(const Recording& recording, const TurnedDraft& draft,
                                  const TurnedChain& more);
/// A thread of passes; of the material nothing is taken.
void finish_thread(const Recording& recording, const HalfSection& material, const stock::Tool& tool,
                   TurnedDraft& draft);

}  // namespace kerf::features
