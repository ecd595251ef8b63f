#pragma once

#include <cstddef>
#include <string>

namespace kerf::base {

/// A stretch of a text that another text takes the place of. Of a list each begins where the one
/// before it ends, or behind that.
struct TextStretch {
  std::size_t at = 0;  ///< bytes
  std::size_t size = 0;
  std::string text{};  ///< what stands there then
};

}  // namespace kerf::base
