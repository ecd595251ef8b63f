#include "output/part/sheet_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "output/solid/bytes.hpp"

namespace kerf::output {
namespace {

using stock::sheet::Sheet;

constexpr float kFullByte = 255;

std::uint8_t byte_of(float energy, float full) {
  return full > 0 ? static_cast<std::uint8_t>(std::lround(energy / full * kFullByte)) : 0;
}

}  // namespace

std::string sheet_part(const Sheet& sheet, std::size_t tile) {
  constexpr int kSide = stock::sheet::kTileSide;
  const stock::sheet::Grid& grid = sheet.grid();
  const int x = static_cast<int>(tile) % grid.tiles_x();
  const int y = static_cast<int>(tile) / grid.tiles_x();
  const int nx = std::min(kSide, grid.nx - kSide * x);
  const int ny = std::min(kSide, grid.ny - kSide * y);
  const Sheet::Coverage& coverage = *sheet.coverage(tile);
  const Sheet::Energy* const energy = sheet.energy(tile);
  const float full = energy == nullptr ? 0 : *std::max_element(energy->begin(), energy->end());
  std::string out;
  append_little_endian(out, static_cast<std::uint32_t>(x));
  append_little_endian(out, static_cast<std::uint32_t>(y));
  append_little_endian(out, static_cast<std::uint16_t>(nx));
  append_little_endian(out, static_cast<std::uint16_t>(ny));
  append_little_endian(out, full);
  std::string covered;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const auto cell = static_cast<std::size_t>(j * kSide + i);
      out += static_cast<char>(energy == nullptr ? 0 : byte_of((*energy)[cell], full));
      covered += static_cast<char>(coverage[cell]);
    }
  }
  out += covered;
  out.resize((out.size() + 3) / 4 * 4);
  return out;
}

}  // namespace kerf::output
