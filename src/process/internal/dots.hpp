#pragma once

#include <memory>
#include <span>

#include "process/recipe.hpp"
#include "process/settled.hpp"

namespace kerf::process {

/// What becomes of greys: the power of each pixel of a row, as a share of the operation's, 0 off.
class Dots {
 public:
  virtual ~Dots() = default;
  /// The rows from the top, each once, from the left; `powers` is as long as `greys`.
  virtual void make(std::span<const double> greys, std::span<double> powers) = 0;
};

[[nodiscard]] std::unique_ptr<Dots> dots_of(const Operation& operation, const Settled& settled,
                                            std::size_t columns);

}  // namespace kerf::process
