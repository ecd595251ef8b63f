#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"

namespace kerf::drawing::svg {

/// The bytes that a picture's href stands for: a data URI, or a file of `folder` itself, which must
/// be no link. A failure's sentence says why not.
[[nodiscard]] base::Outcome<std::string> bytes_of_href(std::string_view href,
                                                       const std::string& folder);

}  // namespace kerf::drawing::svg
