#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/saved/saved_sheet.hpp"
#include "stock/sheet/sheet.hpp"
#include "stock/turned/thread_book.hpp"

namespace kerf::stock::saved {

// .kstock, a part between two set-ups (stock.md §8.4), little endian:
//
//   KSTOCK1\n
//   u32 n, n bytes of JSON: model, grid, zero, volume, programs that it was made by
//   records, each u32 n and n bytes of zlib: the tiles in order
//     zmap      f32 heights by rows along X, then f32 bottoms where the grid has any
//     tridexel  grids X, Y, Z; of a tile u16 numbers of ends, f32 places, 2 i8 directions an end
//     profile   one: u32 loops; of each u32 n, then f64 z, rho, bulge [n]
//     sheet     u32 number of the tile before its record: u8 coverage, f32 energy where it is kept;
//               0xffffffff ends them; then one record of ways, f64 [12] each
//   u32 CRC of 32 bits of everything before
//
// The motions that cut the faces are not written: for the next program all of it is stock.

/// What is told of a part besides its material.
struct PartLabel {
  std::string zero{};                           ///< of the stock, where it was cut
  double volume_mm3 = 0;                        ///< as it was told
  std::vector<std::string> made_by{};           ///< programs, the first one first; names, no paths
  std::vector<turned::TurnedThread> threads{};  ///< on a turned part
};

using TakeBytes = std::function<void(std::string_view)>;

/// Writes a part. Precondition: a height field, dexels or a turned part that is not empty.
void write_part(const PartLabel& label, const Model& model, const TakeBytes& take);
/// The same of a sheet.
struct SheetPart {
  const sheet::Sheet& sheet;
  std::span<const SheetCut> cuts;
  double thickness_mm = 1;
};
void write_part(const PartLabel& label, const SheetPart& part, const TakeBytes& take);

/// Fills the span with the next bytes; returns how many there were: fewer at the end alone.
using GiveBytes = std::function<std::size_t(std::span<char>)>;

struct ReadPart {
  PartLabel label;
  std::shared_ptr<const SavedPart> part;
};

/// Failure (input), a sentence without the name of a file: it is no such file, a newer one, damaged
/// or cut off, or would hold more than `most_bytes`.
[[nodiscard]] base::Outcome<ReadPart> read_part(const GiveBytes& give, std::size_t most_bytes);

/// Whether a file that begins so is meant to be one.
[[nodiscard]] bool is_saved_part(std::string_view head);

}  // namespace kerf::stock::saved
