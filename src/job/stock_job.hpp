#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "job/job.hpp"
#include "job/pass_watch.hpp"
#include "machine/definition/stock_words.hpp"
#include "machine/definition/tools/tool_choice.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "stock/compare/tolerance.hpp"
#include "stock/cutting/cutting_force.hpp"
#include "stock/cutting/motion_cut.hpp"
#include "stock/turned/thread_book.hpp"

namespace kerf::job {

/// Which kind of stock holds the part (stock.md §3).
enum class StockModel : std::uint8_t { automatic, zmap, tridexel, profile, sheet };

class Run;
struct Design;

/// Up to where a program is cut (`--until`).
struct CutUntil {
  std::uint32_t line = 0;          ///< of its own file, before which it ends; 0: by time
  std::optional<double> time_s{};  ///< of the run
};

/// A run that cuts the virtual part, as a value.
struct StockJob {
  Job job;
  machine::StockWord shape{};
  std::string said = "extents";  ///< the shape as its author wrote it
  bool knows_stock = true;       ///< somebody has said what lies on the table
  machine::StockZero zero{};
  struct NamedShape {
    std::string name;
    stock::Workpiece shape;
  };
  std::vector<NamedShape> fixtures{};
  StockModel model = StockModel::automatic;
  std::optional<double> cell_mm{};          ///< largest; none: by the smallest tool or the kerf
  double least_cell_mm = 0;                 ///< that a part beside it has for want of memory
  std::optional<double> kerf_mm{};          ///< of a beam; none: as its machine has it
  std::size_t memory_bytes = 1024UL << 20;  ///< of the model, and of the meshes beside it
  std::size_t mesh_bytes = 0;               ///< what those take of it
  unsigned jobs = 0;                        ///< threads; 0: one a processor
  bool keeps_ways = false;                  ///< of a beam: for exact outlines
  bool checks_start = false;                ///< the axes begin where the machine says
  machine::ToolChoice tools{};              ///< that somebody describes
  std::vector<machine::ImportRemark> remarks{};  ///< what their file has and nobody understood
  std::vector<std::string> made_by{};            ///< programs that have cut the stock before
  std::vector<stock::turned::TurnedThread> threads{};  ///< that it has from them
  std::vector<std::string> notes{};              ///< what was taken otherwise than it was said
  std::optional<stock::CutMaterial> material{};  ///< of the stock; none: no forces are told
  std::vector<base::Code> left_out{};            ///< checks that are not made
  double touch_mm = 0.01;           ///< what may meet nothing is smaller by so much (stock.md §5)
  bool has_real_lengths = false;    ///< Cutter::Settings
  bool stops_at_finding = false;    ///< the first one is the end of what is cut
  bool follows_set_points = false;  ///< cuts where the axes go, corners rounded
  std::optional<CutUntil> until{};
  /// What the part shall be, frame of the stock; null: nobody says.
  std::shared_ptr<const Design> design{};
  bool is_compared = false;               ///< with another part (other_part.hpp)
  stock::compare::Tolerance tolerance{};  ///< of what the part is compared with
  /// Where every motion goes with what it cut; made for each pass over the program. Empty: nowhere.
  std::function<std::unique_ptr<stock::TimedCutSink>(const Run& run)> rows{};
  JobWatch* watch = nullptr;  ///< who looks on; outlives the run
  /// What those see the part against.
  std::optional<DesignInSight> design_in_sight{};
  /// Cells along the longest side of the model, for pictures; 0: as many as `cell_mm` makes.
  int most_along = 0;

  [[nodiscard]] bool compares() const { return design != nullptr || is_compared; }
  [[nodiscard]] std::size_t memory_for_model() const {
    return memory_bytes - std::min(mesh_bytes, memory_bytes);
  }
};

}  // namespace kerf::job
