#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "base/interface.hpp"
#include "stock/sweep/ball_way.hpp"
#include "stock/sweep/body.hpp"
#include "stock/sweep/outcome.hpp"
#include "stock/sweep/sweep.hpp"

namespace kerf::stock {

/// What no tool may touch and none can cut: a clamp, a vice, the chuck.
class Obstacle : public base::Interface {
 public:
  using Contacts = std::array<Contact, kToolParts>;

  /// As people call it.
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// What a tool meets of it on the sweeps of one motion, whatever their kind, deeper than the
  /// touch tolerance of the body. It stays as it is.
  [[nodiscard]] virtual Contacts meet(std::span<const Sweep> sweeps, const Body& body) = 0;
  /// Where the ball of a probe stops, as Model::first_touch().
  [[nodiscard]] virtual std::optional<double> first_touch(const BallWay& ball) const = 0;
};

}  // namespace kerf::stock
