#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "output/reports/run_facts.hpp"
#include "stock/compare/comparison.hpp"
#include "stock/cutting/cut_thread.hpp"
#include "stock/cutting/finding.hpp"
#include "stock/cutting/tool_record.hpp"
#include "stock/sweep/piece.hpp"

namespace kerf::output {

/// What a run that cut the stock came to, as reports tell it. mm, frame of the stock. Plain value.
struct StockFacts {
  struct Tool {
    stock::ToolRecord did;
    std::string type;
    double diameter = 0;
    std::string source;
  };
  struct Told {
    base::Diagnostic diagnostic;
    stock::Finding finding;
  };
  struct Model {
    std::string kind;  ///< "zmap", "tridexel", "profile"
    std::vector<double> cell_mm;
    std::vector<std::uint64_t> cells;
    std::uint64_t bytes = 0;
    double error_mm3 = 0;
    double visited = 0;  ///< columns or dexels compared, a motion
    std::vector<double> grids_mm3;
    std::string reason;
  };

  /// Major and minor are diameters.
  struct Thread {
    std::uint32_t line = 0;
    char axis = 'Z';  ///< along which it is, as nearly as it can be said
    double from = 0;  ///< along that
    double to = 0;
    stock::Vec3 begin;  ///< on the axis of the thread
    stock::Vec3 end;
    double major = 0;
    double minor = 0;
    double pitch = 0;
    int starts = 1;
    stock::Hand hand = stock::Hand::right;
    bool is_inside = false;  ///< in a hole
    bool is_milled = false;  ///< its groove is cut into the part, and is in removed_mm3
    double volume_mm3 = 0;
    std::uint32_t motion = 0;  ///< that began it
  };

  /// Of a sheet under a beam.
  struct Sheet {
    struct Piece {
      double area_mm2 = 0;
      stock::Bounds extents;
      bool is_held = false;
    };
    double kerf_mm = 0;
    double thickness_mm = 0;
    double cut_mm2 = 0;
    double cut_mm = 0;              ///< of the ways with the beam on, on the sheet or beside it
    std::vector<Piece> pieces;      ///< the largest first
    std::uint64_t piece_count = 0;  ///< of all; more than `pieces` has where they are very many
    double energy_j = 0;            ///< that the beam gave
    double peak_j_mm2 = 0;
  };

  /// A line, and its share of a region.
  struct LineShare {
    std::string file;
    std::uint32_t line = 0;
    double share = 0;
  };
  /// With a design.
  struct Compared {
    stock::compare::Comparison found;
    std::vector<std::vector<LineShare>> lines;  ///< of each region, the largest share first
  };

  /// With another part: what only this one has is an excess, what only the other one has a gouge.
  struct Against {
    std::string file;
    std::optional<RunFacts::Status> status;  ///< of the other run; none: the part was saved
    stock::compare::Comparison found;
    std::vector<std::vector<LineShare>> lines;  ///< of each region, as Compared has them
    std::vector<std::vector<LineShare>> there;  ///< of the other program
  };

  RunFacts run;
  std::string shape;
  std::string zero;
  stock::Vec3 origin;
  stock::Bounds stock_extents;
  double stock_mm3 = 0;
  Model model;
  std::optional<Sheet> sheet;
  std::optional<Compared> compare;
  std::optional<Against> against;
  double removed_mm3 = 0;
  double left_mm3 = 0;
  stock::Bounds extents;             ///< of what is left; low > high: nothing is
  std::vector<stock::Piece> pieces;  ///< the largest first
  std::vector<Thread> threads;       ///< but of milled ones, their material is not in removed_mm3
  bool turns = false;                ///< X is told as a diameter, and there is no Y
  std::vector<Tool> tools;
  std::vector<Told> findings;
  std::vector<std::string> not_checked;
  std::vector<control::Assumption> assumed;
};

}  // namespace kerf::output
