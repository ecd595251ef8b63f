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
/// the control has read it: the run is made again up to now, and the key takes effect before that
/// block is executed. What of it shows is done now.
///
/// The axes have gone the way that they have gone. Where it would have been another, because they
/// could not have come to rest any more or turn off, it acts on the first block behind that where
/// it can. Nothing: there is none among those that were read.
///
/// Takes as long as some runs up to now. Precondition: `key` is what acts_on_axes() says.
[[nodiscard]] std::optional<ReadAgain> read_again(const Journal& journal, LiveCore& now,
                                                  const Operation& key);

}  // namespace kerf::machine
