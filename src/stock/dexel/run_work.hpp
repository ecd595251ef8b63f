#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "stock/dexel/late_normals.hpp"
#include "stock/dexel/passage.hpp"
#include "stock/dexel/posed_tool.hpp"
#include "stock/dexel/stroke_tree.hpp"
#include "stock/dexel/tile.hpp"
#include "stock/dexel/tile_window.hpp"
#include "stock/dexel/uncut_rest.hpp"

namespace kerf::stock::dexel {

/// Cuts the dexels of one tile by many straight strokes of one tool at once, where nobody asks what
/// each of them removes. What comes out is the same to the last bit as one after the other:
///
///   of a dexel      |#########################################|   material
///   stroke 1            |------|
///   stroke 2               |------|                 passed over by others: they need not be found
///   stroke 3                 |--------|
///   stroke 4            |-------------------|       found first: it reaches deepest
///   left, owned by  |###|1                  4|################|   those that end somewhere
///
/// Strokes are a tree of halves (StrokeTree); each half is looked at as one stroke of a solid that
/// is grown by as much as its strokes leave their chord. Where that meets nothing which the strokes
/// found so far do not pass over, by a margin, none of its strokes changes anything. Those found
/// are cut in their order.
class RunWork {
 public:
  struct Step {
    const Stroke* stroke = nullptr;
    std::uint32_t motion = 0;
    bool follows = false;  ///< Passage::follow()
  };

  /// All outlive this.
  RunWork(const TilePlace& place, Tile& tile, const PosedTool& posed, std::span<const Step> steps);

  /// A part that may meet nothing may meet something of what is there now.
  [[nodiscard]] bool may_collide();
  void cut(LateNormals& normals);

 private:
  /// A solid on one stroke, or on all strokes of a node.
  struct Sight {
    CellRange rows;
    CellRange columns;
    float low;
    float high;
    float grown;  ///< by how much its form is less than that of the solid
    Glance glance;
    const Passage* passage;  ///< of one stroke

    [[nodiscard]] bool reaches(int column, int row, int columns_more, int rows_more) const {
      return row + rows_more > rows.first && row <= rows.last &&
             column + columns_more > columns.first && column <= columns.last;
    }
  };
  /// A solid on all strokes, made where somebody looks.
  struct Tree {
    const PosedSolid* solid;
    std::vector<const Sight*> near;
    std::vector<const Sight*> far;
    std::vector<std::uint16_t> cuts;  ///< as LateNormals has them; 0: not yet
    std::size_t guess;                ///< a node: the stroke that was found last
  };
  /// That one stroke of a solid passes over a piece of a dexel.
  struct Cut {
    std::size_t dexel;  ///< of four
    std::size_t stroke;
    std::size_t tree;
    float low;
    float high;
  };
  /// Four dexels.
  struct Row {
    int column;
    int row;
    double b;
    double c;
    UncutRest rest;
    unsigned changes = 0;  ///< of the rest
  };
  struct Depth {
    unsigned met = 0;  ///< bits of dexels
    /// The less, the deeper: of the form of the solid, mm².
    float least = std::numeric_limits<float>::infinity();
  };

  [[nodiscard]] std::vector<Tree> trees(const std::vector<PosedSolid>& solids, bool edges) const;
  [[nodiscard]] const Sight& near(Tree& tree, std::size_t node);
  [[nodiscard]] const Sight& far(Tree& tree, std::size_t node);
  [[nodiscard]] const Sight* add_near(const PosedSolid& posed, std::size_t node);
  [[nodiscard]] Sight sight(const PosedSolid& posed, const Passage& passage, std::size_t node,
                            int dexels_apart) const;
  [[nodiscard]] Passage passage(const Solid& solid, std::size_t node) const;

  /// What the strokes may reach.
  struct Window {
    CellRange rows{0, -1};
    CellRange columns{0, -1};
    Tile::Stretch along{1, -1};
  };
  [[nodiscard]] Window window(std::vector<Tree>& trees);
  template <class Visit>
  void each_block(std::vector<Tree>& trees, const Window& window, Visit&& visit);
  [[nodiscard]] unsigned active(Tree& tree, std::size_t node, int column, int row);
  [[nodiscard]] Row row_at(int column, int row, Tile::Stretch along) const;
  [[nodiscard]] Depth depth(Tree& tree, std::size_t node, const Row& row);
  template <class Found>
  void search(Tree& tree, Row& row, Found&& found);
  template <class Found>
  void search(Tree& tree, std::size_t node, unsigned met, Row& row, Found&& found);
  template <class Found>
  void meet(Tree& tree, std::size_t node, unsigned met, Row& row, Found&& found);
  void cut_block(int column, int row, const Window& window, LateNormals& normals);
  bool cut_row(const Row& row, LateNormals& normals);
  [[nodiscard]] std::uint16_t cut_of(const Cut& cut, const Row& row, LateNormals& normals);

  TilePlace place_;
  Tile& tile_;
  const PosedTool& posed_;
  std::span<const Step> steps_;
  StrokeTree strokes_;
  std::deque<Sight> sights_;
  std::deque<Passage> passages_;
  std::vector<Tree> edges_;
  std::vector<Tree> others_;
  std::vector<Cut> cuts_;  // of a row
};

}  // namespace kerf::stock::dexel
