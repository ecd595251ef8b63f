#pragma once

#include <map>
#include <string>
#include <string_view>

#include "geometry/vec2.hpp"

namespace kerf::features {

/// Names features by where they are, so that the name stays when others come or go: the checksum of
/// zip files (CRC, 32 bits) of zero, tool, kind, place and bottom in whole micrometres, as eight
/// hexadecimal digits. Equal ones get -2, -3 in order.
class Keys {
 public:
  [[nodiscard]] std::string of(std::string_view zero, std::uint32_t tool, std::string_view kind,
                               geometry::Vec2 at, double bottom);

 private:
  std::map<std::string, int> known_;
};

}  // namespace kerf::features
