#pragma once

#include <span>
#include <vector>

#include "stock/dexel/across.hpp"
#include "stock/dexel/hulls.hpp"
#include "stock/dexel/late_normals.hpp"
#include "stock/dexel/lattice.hpp"
#include "stock/dexel/passage.hpp"
#include "stock/dexel/posed_tool.hpp"
#include "stock/dexel/strokes.hpp"
#include "stock/dexel/tally.hpp"
#include "stock/dexel/tile.hpp"
#include "stock/dexel/tile_window.hpp"
#include "stock/dexel/turn.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::dexel {

/// One sweep, as every tile cuts it.
struct Task {
  const Sweep* sweep = nullptr;
  const PosedTool* posed = nullptr;
  std::span<const Stroke> strokes;
  std::size_t number = 0;  ///< of its outcome
  int main_axis = 2;       ///< of the dexels that look along the tool best: they count volumes
  double turn_tolerance_mm = 0;
  /// The sweep before this one cut with the same body in the same direction and ended where this
  /// one begins.
  bool follows = false;

  /// Its edges may meet material.
  [[nodiscard]] bool cuts() const {
    return sweep->kind == SweepKind::cut && posed->tool->body.cuts;
  }
};

/// Cuts and checks the dexels of one tile, sweep by sweep. Of a sweep the edges come first; then
/// each part that may meet nothing, shrunk by the touch tolerance, is compared with what is left,
/// and where it meets more than that tolerance along a dexel this dexel is a contact and loses what
/// the whole part passes over. So no order of strokes counts; a tool that slides along what it has
/// cut before meets nothing, for the dexels of all three directions are exact along themselves.
class TileWork {
 public:
  /// `middle`: of the stock's box, in the frame of the stock.
  TileWork(const Lattice& lattice, Tile& tile, int first_column, int first_row, Vec3 middle);

  /// Those of the tasks that have these numbers, in their order.
  void cut(std::span<const Task> tasks, std::span<const std::uint32_t> numbers, Tally& tally);
  /// Whether a body as large as it is, on a straight way, meets material.
  [[nodiscard]] bool meets(const PosedTool& posed, const Stroke& stroke);

 private:
  void cut(const Task& task, Tally& tally);
  [[nodiscard]] bool cut_run(std::span<const Task> tasks, std::span<const std::uint32_t> numbers);

  struct Place {
    std::size_t dexel;
    double b;
    double c;
  };
  struct Found {
    float shrunk = 0;  ///< mm that the shrunk part meets in this stroke
    float removed = 0;
    float at = 0;
    std::uint32_t stroke = 0;
    bool is_contact = false;
  };

  [[nodiscard]] TileWindow window(const Bounds& box) const { return {place_, tile_, box}; }
  template <class Glimpse, class Act>
  void visit_block(const TileWindow& window, int column, int row, Glimpse&& glimpse, Act&& act);
  template <class Skip, class Visit>
  void visit_blocks(const TileWindow& window, const Glance* far, Skip&& skip, Visit&& visit);
  template <class Act>
  void visit(const PosedSolid& solid, const Frame& frame, const Stroke& stroke, bool follows,
             Act&& act);
  template <class Meets, class Act>
  void visit_turn(const Task& task, const Solid& solid, Meets&& meets, Act&& act);

  void cut_edges(const Task& task, const Across& across, Outcome& outcome);
  void cut_solid(const Task& task, const PosedSolid& solid, const Stroke& stroke, bool follows,
                 const Across& across, Outcome& outcome);
  bool take(const Task& task, const Place& place, const Meeting& meeting, const Passage& passage,
            const Passage* core, const Across& across, Outcome& outcome);
  double subtract(const Task& task, const Place& place, const Meeting& meeting,
                  const Passage& passage);
  void count(const Task& task, const Place& place, double length, const Tile::Stretch& span,
             const Across& across, Outcome& outcome) const;
  void count_core(const Place& place, const Meeting& meeting, const Passage& core,
                  Outcome& outcome) const;

  void check(const Task& task, ToolPart part, Tally& tally);
  void find_contacts(const Task& task, ToolPart part);
  void note(const Task& task, const Place& place, const Meeting& meeting, std::uint32_t stroke);
  void remove_contacts(const Task& task, ToolPart part, Outcome& outcome);
  bool remove_contact(const Task& task, const Place& place, const Meeting& meeting,
                      const Passage& passage);
  void tell_contacts(const Task& task, ToolPart part, Tally& tally);
  template <class Act>
  void each_solid(const Task& task, const std::vector<PosedSolid>& solids, ToolPart part,
                  Act&& act);

  [[nodiscard]] Vec3 place_of(double along, double b, double c) const;

  const Lattice& lattice_;
  Tile& tile_;
  TilePlace place_;
  Vec3 middle_;
  std::uint64_t visited_ = 0;
  Hulls hulls_;
  LateNormals normals_;
  std::uint16_t cut_ = 0;              // that goes on; 0: ends get their normals at once
  std::vector<Found> found_;           // of each dexel, when there is anything
  std::vector<std::size_t> contacts_;  // dexels
  std::vector<std::size_t> noted_;
};

}  // namespace kerf::stock::dexel
