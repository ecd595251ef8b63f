#include "stock/surface/internal/bits.hpp"

#include <array>

namespace kerf::stock::surface {
namespace {

using Square = std::array<std::uint64_t, 64>;

bool is_empty(const std::vector<std::uint64_t>& words) {
  return std::all_of(words.begin(), words.end(), [](std::uint64_t word) { return word == 0; });
}

/// Rows and bits change places: blocks of half of the size are swapped, down to single bits.
void transpose(Square& rows) {
  std::uint64_t mask = 0xffffffffULL;
  for (std::size_t half = 32; half != 0; half >>= 1, mask ^= mask << half) {
    for (std::size_t k = 0; k < 64; k = ((k | half) + 1) & ~half) {
      const std::uint64_t swap = ((rows[k] >> half) ^ rows[k | half]) & mask;
      rows[k] ^= swap << half;
      rows[k | half] ^= swap;
    }
  }
}

}  // namespace

std::vector<std::uint64_t> turned_from_x(const std::vector<std::uint64_t>& words, Place count) {
  const auto nx = static_cast<std::size_t>(count[0]);
  const auto ny = static_cast<std::size_t>(count[1]);
  const auto nz = static_cast<std::size_t>(count[2]);
  std::vector<std::uint64_t> out(nx * ny);
  if (is_empty(words)) return out;
  for (std::size_t j = 0; j < ny; ++j) {
    Square rows{};
    for (std::size_t k = 0; k < nz; ++k) rows[k] = words[k * ny + j];
    transpose(rows);
    for (std::size_t i = 0; i < nx; ++i) out[j * nx + i] = rows[i];
  }
  return out;
}

std::vector<std::uint64_t> turned_from_y(const std::vector<std::uint64_t>& words, Place count) {
  const auto nx = static_cast<std::size_t>(count[0]);
  const auto ny = static_cast<std::size_t>(count[1]);
  const auto nz = static_cast<std::size_t>(count[2]);
  std::vector<std::uint64_t> out(nx * ny);
  if (is_empty(words)) return out;
  for (std::size_t i = 0; i < nx; ++i) {
    Square rows{};
    for (std::size_t k = 0; k < nz; ++k) rows[k] = words[i * nz + k];
    transpose(rows);
    for (std::size_t j = 0; j < ny; ++j) out[j * nx + i] = rows[j];
  }
  return out;
}

}  // namespace kerf::stock::surface
