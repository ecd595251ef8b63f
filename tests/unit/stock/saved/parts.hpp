#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "stock/saved/part_file.hpp"

namespace kerf::stock::saved::test {

inline constexpr std::size_t kRoom = 64 << 20;

/// The bytes of a .kstock.
template <typename Part>
std::string file_of(const PartLabel& label, const Part& part) {
  std::string bytes;
  write_part(label, part, [&](std::string_view more) { bytes += more; });
  return bytes;
}

/// Reads them in pieces of 1000 bytes.
inline base::Outcome<ReadPart> read_bytes(std::string_view bytes, std::size_t most_bytes = kRoom) {
  std::size_t at = 0;
  return read_part(
      [&](std::span<char> into) {
        const std::size_t count = std::min({into.size(), bytes.size() - at, std::size_t{1000}});
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), count, into.begin());
        at += count;
        return count;
      },
      most_bytes);
}

inline ReadPart part_of(const std::string& bytes) {
  auto read = read_bytes(bytes);
  EXPECT_TRUE(read) << read.error().message;
  return read ? std::move(*read) : ReadPart{};
}

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

/// Moves of tool 0 that begin with a rapid above the stock.
inline std::vector<Sweep> level_sweeps(std::uint64_t seed, int count) {
  Dice dice(seed);
  std::vector<Sweep> sweeps;
  Vec3 at{0, 0, 50};
  for (int i = 0; i < count; ++i) {
    const Vec3 to = i == 0 ? Vec3{1, 1, 50}
                           : Vec3{dice.between(-12, 12), dice.between(-9, 9), dice.between(-4, 3)};
    sweeps.push_back({.way = StraightWay{at, to},
                      .kind = i == 0 ? SweepKind::rapid : SweepKind::cut,
                      .motion = static_cast<std::uint32_t>(i + 1)});
    at = to;
  }
  return sweeps;
}

inline void cut_all(Model& model, const std::vector<Sweep>& sweeps) {
  std::vector<Outcome> outcomes(sweeps.size());
  model.cut(sweeps, outcomes);
}

inline Body mill(double diameter) {
  const double r = diameter / 2;
  return {Profile({{{0, 0}, {r, 0}, 0, ToolPart::edge}, {{r, 0}, {r, 100}, 0, ToolPart::edge}})};
}

}  // namespace kerf::stock::saved::test
