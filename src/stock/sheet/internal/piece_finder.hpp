#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "stock/sheet/internal/tile_parts.hpp"
#include "stock/sheet/pieces.hpp"

namespace kerf::stock::sheet {

/// Joins the parts of tiles to pieces. Parts that end within their tile are pieces at once, so what
/// is kept at a time is what comes to the edges of tiles.
class PieceFinder {
 public:
  explicit PieceFinder(const Sheet& sheet);

  [[nodiscard]] Pieces find();

 private:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xffffffff;

  /// A part of a piece, in cells of the sheet.
  struct Part {
    std::uint64_t left = 0;
    std::uint64_t first = 0;
    int i0, i1, j0, j1;
    bool is_held = false;
  };
  /// The nodes of the cells at the edges of a touched tile: low and high X, low and high Y.
  using Edges = std::array<std::array<Node, kTileSide>, 4>;
  /// What is left of a cell that is cut, at the edge of its tile: for the neighbour in this tile
  /// that has most, unless one in the next tile has more.
  struct Rest {
    std::size_t tile = 0;
    int cell = 0;
    std::uint8_t left = 0;
    std::uint8_t covered = 255;  // of the neighbour
    Node node = kNone;
  };

  void take_untouched(std::size_t tile);
  void take_touched(std::size_t tile, const Sheet::Coverage& cells);
  void share_rests(std::size_t tile, const Sheet::Coverage& cells, const TileParts& parts,
                   const std::vector<Node>& nodes, std::vector<Part>& whole);
  void join_behind(std::size_t tile);
  void join(std::size_t tile, std::size_t other, std::size_t edge, std::size_t edge_of_other,
            int length);
  void settle(Rest rest);
  [[nodiscard]] Part part_of(std::size_t tile, const TilePart& part) const;
  [[nodiscard]] Node add(const Part& part);
  [[nodiscard]] Node root(Node node);
  void unite(Node a, Node b);
  void close(const Part& part);
  void keep_largest();
  [[nodiscard]] Node node_at(std::size_t tile, std::size_t edge, int place) const;

  [[nodiscard]] int column(std::size_t tile) const { return static_cast<int>(tile % tiles_x_); }
  [[nodiscard]] int row(std::size_t tile) const { return static_cast<int>(tile / tiles_x_); }
  [[nodiscard]] int width(std::size_t tile) const;
  [[nodiscard]] int height(std::size_t tile) const;

  const Sheet& sheet_;
  const Grid& grid_;
  std::size_t tiles_x_;
  std::vector<Node> parents_;
  std::vector<Part> parts_;                       // of each node; of roots that of all
  std::vector<Node> of_untouched_;                // by tile
  std::unordered_map<std::size_t, Edges> edges_;  // of touched tiles
  std::vector<Rest> rests_;
  std::vector<Part> closed_;
  std::uint64_t count_ = 0;
};

}  // namespace kerf::stock::sheet
