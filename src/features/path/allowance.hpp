#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string>

#include "base/work_limit.hpp"

namespace kerf::features {

/// What a recognition may take at most; 0: as much as it wants.
struct Bounds {
  double seconds = 0;            ///< of computing; as long again for telling what was found
  std::stop_token unwanted{};    ///< stopped by any thread: it ends within milliseconds
  std::size_t memory_bytes = 0;  ///< of the recording and of all regions
};

/// What a recognition has taken of its bounds. Whoever computes for long asks is_over() between two
/// steps and comes to an end; what is over stays over. Of one thread.
class Allowance {
 public:
  Allowance() = default;  ///< of all there is
  explicit Allowance(const Bounds& bounds)
      : bounds_(bounds), limit_(bounds.seconds, bounds.unwanted) {}

  [[nodiscard]] bool is_over();
  /// So many bytes are kept from now on.
  void keep(std::size_t bytes) { kept_ += bytes; }
  /// From now on what was found is told: time begins anew, and memory is no matter.
  void begin_telling();
  /// Why something is over, as the end of a sentence; empty: nothing ever was.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  [[nodiscard]] bool has_no_room() const {
    return bounds_.memory_bytes > 0 && kept_ > bounds_.memory_bytes;
  }

  Bounds bounds_{};
  base::WorkLimit limit_{};
  std::size_t kept_ = 0;
  bool is_over_ = false;
  bool tells_ = false;
  std::string reason_{};
};

}  // namespace kerf::features
