#pragma once

#include <future>
#include <span>

#include "base/helper.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock {

/// A model cuts on a thread of its own; who waits for it helps.
class CutBeside {
 public:
  /// Begins to cut; without such a thread it is done here. The model, sweeps and outcomes stay as
  /// they are until await(), which comes before the next begin().
  void begin(Model& model, std::span<const Sweep> sweeps, std::span<Outcome> outcomes);
  /// Until what began has ended; throws what it has thrown.
  void await();

 private:
  base::Helper helper_;
  std::future<void> cutting_;  // last: its end waits for the thread
};

}  // namespace kerf::stock
