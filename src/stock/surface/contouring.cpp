#include "stock/surface/contouring.hpp"

#include <algorithm>

#include "base/each_by_threads.hpp"
#include "stock/surface/internal/patch_maker.hpp"
#include "stock/surface/internal/places.hpp"

namespace kerf::stock::surface {
namespace {

/// A patch without the points that belong to the blocks before it.
struct Part {
  Patch patch;
  std::vector<std::uint32_t> numbers;  ///< of all its points in the whole surface, when known
  std::vector<bool> is_own;
  std::size_t own = 0;
};

/// Joins the patches of all blocks: a point belongs to the block that has its cell.
class Joiner {
 public:
  Joiner(const Samples& samples, Place blocks) : samples_(samples), blocks_(blocks) {}

  [[nodiscard]] Surface join(std::vector<Part>& parts) {
    number_own(parts);
    for (Part& part : parts) find_others(part, parts);
    Surface all;
    all.mesh.points.reserve(count_);
    all.point_owners.reserve(count_);
    for (Part& part : parts) {
      take(part, all);
      part.patch = {};
    }
    return all;
  }

 private:
  [[nodiscard]] std::size_t block_of(std::uint64_t key) const {
    const std::uint64_t nx = samples_.points(0).size();
    const std::uint64_t ny = samples_.points(1).size();
    const std::uint64_t cell = key / 4;
    const auto block = [](std::uint64_t c) {
      return static_cast<std::size_t>(c) / Contouring::kBlock;
    };
    return (block(cell / (nx * ny)) * index(blocks_[1]) + block(cell / nx % ny)) *
               index(blocks_[0]) +
           block(cell % nx);
  }

  void number_own(std::vector<Part>& parts) {
    for (std::size_t b = 0; b < parts.size(); ++b) {
      Part& part = parts[b];
      part.numbers.resize(part.patch.keys.size());
      part.is_own.resize(part.patch.keys.size());
      for (std::size_t i = 0; i < part.patch.keys.size(); ++i) {
        part.is_own[i] = block_of(part.patch.keys[i]) == b;
        if (part.is_own[i]) part.numbers[i] = count_++;
      }
    }
  }

  void find_others(Part& part, const std::vector<Part>& parts) const {
    for (std::size_t i = 0; i < part.numbers.size(); ++i) {
      if (part.is_own[i]) continue;
      const std::uint64_t key = part.patch.keys[i];
      const Part& owner = parts[block_of(key)];
      const auto& keys = owner.patch.keys;
      const auto at = std::lower_bound(keys.begin(), keys.end(), key) - keys.begin();
      part.numbers[i] = owner.numbers[static_cast<std::size_t>(at)];
    }
  }

  static void take(const Part& part, Surface& all) {
    const Patch& patch = part.patch;
    for (std::size_t i = 0; i < part.numbers.size(); ++i) {
      if (!part.is_own[i]) continue;
      all.mesh.points.push_back(patch.points[i]);
      all.point_owners.push_back(patch.point_owners[i]);
    }
    for (const mesh::Triangle& t : patch.triangles) {
      all.mesh.triangles.push_back({part.numbers[t[0]], part.numbers[t[1]], part.numbers[t[2]]});
    }
    all.owners.insert(all.owners.end(), patch.owners.begin(), patch.owners.end());
  }

  const Samples& samples_;
  Place blocks_;
  std::uint32_t count_ = 0;
};

}  // namespace

Contouring::Contouring(const Samples& samples) : samples_(samples), blocks_{} {
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = static_cast<int>(samples.points(axis).size()) - 1;
    blocks_[index(axis)] = (cells + kBlock - 1) / kBlock;
  }
}

Patch Contouring::patch(Place block) const {
  Place begin{};
  Place end{};
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = static_cast<int>(samples_.points(axis).size()) - 1;
    begin[index(axis)] = block[index(axis)] * kBlock;
    end[index(axis)] = std::min(begin[index(axis)] + kBlock, cells);
  }
  return PatchMaker(samples_, begin, end).make();
}

Bounds Contouring::seen(Place block) const {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double>& points = samples_.points(axis);
    const int last = static_cast<int>(points.size()) - 1;
    const int begin = block[index(axis)] * kBlock;
    // One more, for samples whose planes lean on their neighbours.
    const int around = PatchMaker::kAround + Samples::kReach;
    low[index(axis)] = points[index(std::max(begin - around, 0))];
    high[index(axis)] = points[index(std::min(begin + kBlock + around, last))];
  }
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

Surface Contouring::surface(unsigned jobs) const {
  const std::size_t count = index(blocks_[0]) * index(blocks_[1]) * index(blocks_[2]);
  std::vector<Part> parts(count);
  base::each_by_threads(count, base::useful_threads(jobs), [&](std::size_t b) {
    const int number = static_cast<int>(b);
    parts[b].patch = patch({number % blocks_[0], number / blocks_[0] % blocks_[1],
                            number / (blocks_[0] * blocks_[1])});
  });
  return Joiner(samples_, blocks_).join(parts);
}

}  // namespace kerf::stock::surface
