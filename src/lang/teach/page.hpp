#pragma once

#include <array>
#include <vector>

#include "lang/teach/record_reader.hpp"
#include "lang/vm/code_page.hpp"

namespace kerf::teach {

/// What a do_block instruction executes: a record, and where its words stand.
struct Block {
  /// The words of the longest record.
  static constexpr std::size_t kMostWords = 11;

  Record record;
  std::array<vm::Span, kMostWords> words{};
};

/// The code of a stretch of a .tch file.
struct TeachPage : vm::CodePage {
  std::vector<Block> blocks;
  RecordReader::Position next;  ///< where the page behind it begins
  bool last = false;            ///< the file ends with this page

  void clear();
  /// Bytes that the page occupies, for the budget of those who keep pages.
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace kerf::teach
