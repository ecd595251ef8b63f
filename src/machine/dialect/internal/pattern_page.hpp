#pragma once

#include <vector>

#include "drive/pattern/listing.hpp"
#include "lang/vm/code_page.hpp"

namespace kerf::machine {

/// The code of a stretch of a listing: a do_block for each line that says something.
struct PatternPage : vm::CodePage {
  struct Block {
    drive::ListedMove move;
    std::uint32_t line = 0;  ///< from 1
  };

  std::vector<Block> blocks;
  bool last = false;  ///< the file ends with this page

  void clear();
  /// Bytes that the page occupies, for the budget of those who keep pages.
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace kerf::machine
