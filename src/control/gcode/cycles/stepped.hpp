#pragma once

namespace kerf::control {

/// Something that a block makes one part at a time, so that no block floods whoever receives the
/// motions.
class Stepped {
 public:
  virtual ~Stepped() = default;

  /// Parts are left.
  [[nodiscard]] virtual bool running() const = 0;
  /// Makes the next one. False: an alarm was raised. Precondition: running().
  [[nodiscard]] virtual bool step() = 0;
  /// What is left is not made.
  virtual void stop() = 0;
};

}  // namespace kerf::control
