#pragma once

#include <string_view>
#include <vector>

namespace kerf::base {

/// A file of licences that is compiled in.
struct Notice {
  std::string_view file;
  std::string_view text;
};

/// THIRD_PARTY_NOTICES: what others wrote and Kerf is made with, its only entry.
[[nodiscard]] const std::vector<Notice>& notices();

}  // namespace kerf::base
