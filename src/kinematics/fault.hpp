#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/axes.hpp"
#include "base/diagnostic_code.hpp"
#include "base/result.hpp"

namespace kerf::kinematics {

/// Why a tip has no joints. A value with a sentence; who knows the program adds the place.
struct Fault {
  enum class Kind : std::uint8_t {
    out_of_reach,  ///< the linkage cannot get there in any position of its joints
    singular,      ///< the joints or their rates are not determined there
    limit,         ///< a joint would stand beyond its range
  };

  Kind kind{};
  std::string message;  ///< with the values and their units
  base::Axis joint{};   ///< limit: which one, in the order of the machine file
  double value = 0;     ///< limit: where it would stand, mm or degrees
  double limit = 0;     ///< limit: the end of its range that this is beyond
};

/// What an alarm about it is raised with.
[[nodiscard]] base::Code code_of(Fault::Kind kind);

/// OUT_OF_REACH, SINGULAR or LIMIT.
[[nodiscard]] std::string_view name_of(Fault::Kind kind);

template <typename T>
using Result = tl::expected<T, Fault>;

}  // namespace kerf::kinematics
