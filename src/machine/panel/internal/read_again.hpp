#pragma once

#include <memory>
#include <optional>

#include "machine/panel/internal/journal.hpp"

namespace kerf::machine {

/// A run as it stands now, and how it came there.
struct ReadAgain {
  Journal journal;
  std::unique_ptr<LiveCore> core;
};

/// Lets what the operator does now act on the first block that the axes have not begun, although
/// the control has read it: the run is made again up to now, and `effect` is done before that block
/// is executed. `shown` is done now.
///
/// The axes have gone the way that they have gone. Where it would have been another, because they
/// could not have come to rest any more or turn off, it acts on the first block behind that where
/// it can. Nothing: there is none among those that were read.
///
/// Takes as long as some runs up to now. Precondition: now.is_ahead().
[[nodiscard]] std::optional<ReadAgain> read_again(const Journal& journal, LiveCore& now,
                                                  const Journal::Act& shown,
                                                  const Journal::Act& effect);

}  // namespace kerf::machine
