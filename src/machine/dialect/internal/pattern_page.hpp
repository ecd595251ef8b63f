#pragma once

#include "drive/pattern/listing.hpp"
#include "lang/vm/line_page.hpp"

namespace kerf::machine {

/// A line of a listing that says something.
struct PatternBlock {
  drive::ListedMove move;
  std::uint32_t line = 0;  ///< from 1
};

using PatternPage = vm::LinePage<PatternBlock>;

}  // namespace kerf::machine
