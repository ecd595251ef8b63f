#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/source_file.hpp"
#include "machine/definition/stock_words.hpp"

namespace kerf::machine {

/// What a comment of a program says of its stock (stock.md §2.1).
struct CommentedStock {
  std::uint32_t line = 0;
  std::string said{};               ///< as a word of `--stock`
  std::optional<StockWord> word{};  ///< none: it is no stock
  std::string wrong{};              ///< why; else empty
};

/// The first comment of a program that begins with WORKPIECE, in the program's own unit;
/// `mm_per_unit` where that has neither G20 nor G21. None: it has no such comment.
///
///   (WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-20,XMAX=100,YMAX=60,ZMAX=0)
///   (WORKPIECE,CYLINDER,AXIS=Z,X=0,Y=0,ZMIN=-20,ZMAX=0,DIAMETER=50)      AXIS=X: XMIN, XMAX, Y, Z
///   (WORKPIECE,TUBE,…,DIAMETER=50,INNER_DIAMETER=20)
[[nodiscard]] std::optional<CommentedStock> stock_in_comments(const base::SourceFile& program,
                                                              double mm_per_unit);

}  // namespace kerf::machine
