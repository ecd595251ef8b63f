#pragma once

#include <optional>

#include "stock/tool/insert.hpp"
#include "stock/tool/profile.hpp"

namespace kerf::stock {

/// A tool as models cut with it.
struct Body {
  Profile profile;
  double core_mm = 0;  ///< radius within which its face does not cut; 0: it cuts at its centre
  /// By how much it is made smaller on all sides where it must not meet anything (stock.md §5): all
  /// of it at rapids, all but the edges in cuts.
  double touch_mm = 0.01;
  bool cuts = true;  ///< else even its edges may meet nothing: a probe
  /// Of a lathe, in place of the profile.
  std::optional<Insert> insert{};
};

}  // namespace kerf::stock
