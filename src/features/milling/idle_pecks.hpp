#pragma once

#include <utility>
#include <vector>

#include "features/milling/stroke.hpp"

namespace kerf::features {

/// Plunges that have met nothing, while nobody knows whether they are the first pecks of a hole
/// below them: a cycle that begins above the work pecks there, too.
class IdlePecks {
 public:
  /// The recording must outlive this.
  explicit IdlePecks(const Recording& recording) : recording_(recording) {}

  void add(const PlungeRun& plunge) { pecks_.push_back(plunge); }
  /// At the place of the last one, with nothing but rapids between.
  [[nodiscard]] bool go_on_with(const PlungeRun& plunge) const;
  /// All of them, in their order; there are none then.
  [[nodiscard]] std::vector<PlungeRun> take() { return std::exchange(pecks_, {}); }

 private:
  const Recording& recording_;
  std::vector<PlungeRun> pecks_;
};

}  // namespace kerf::features
