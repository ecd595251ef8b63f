#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "stock/tool/measure.hpp"

namespace kerf::stock {

/// What a designation by ISO 1832 says of an insert: `CNMG120408`.
struct InsertCode {
  char shape = 'C';
  /// nose_radius, tip_angle (not of a round one), ic, kapr: those that the designation or its shape
  /// tells.
  Measures measures;
};

/// The first letter is the shape; of what stands behind the four letters characters 1 and 2 are the
/// length of the edge, 5 and 6 the nose radius in 0.1 mm (`00`: sharp, `M0`: round). What follows
/// is the maker's. Error: a sentence without a full stop.
[[nodiscard]] tl::expected<InsertCode, std::string> read_insert_code(std::string_view text);

}  // namespace kerf::stock
