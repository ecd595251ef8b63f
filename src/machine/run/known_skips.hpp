#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/skip_signal.hpp"

namespace kerf::machine {

/// Of each probing move in turn the share of it at which the skip signal comes on, or nothing.
using Skips = std::vector<std::optional<double>>;

/// Skip signals as they came in an earlier run of the same program: what has met a part meets it
/// again where there is none.
class KnownSkips final : public motion::SkipSignal {
 public:
  explicit KnownSkips(Skips skips) : skips_(std::move(skips)) {}

  [[nodiscard]] std::optional<double> comes_on(const motion::SkipMove&) override {
    return next_ < skips_.size() ? skips_[next_++] : std::nullopt;
  }

 private:
  Skips skips_;
  std::size_t next_ = 0;
};

}  // namespace kerf::machine
