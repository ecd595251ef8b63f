#pragma once

#include <string>
#include <vector>

#include "base/source_file.hpp"
#include "drawing/cleaning.hpp"
#include "drawing/drawing.hpp"
#include "drawing/nesting.hpp"
#include "process/plan.hpp"

namespace kerf::output {

/// What making a plan comes to, by the interpolator that would drive the machine.
struct Made {
  double beam_mm = 0;  ///< with the beam on, or of a mill while it cuts
  double travel_mm = 0;
  double overscan_mm = 0;  ///< at feed without beam
  double beam_s = 0;
  double time_s = 0;
  double energy_j = 0;
  std::size_t pierces = 0;
  base::TipPoint low, high;  ///< of what is cut; in that order where there is anything
  bool has_extents = false;

  void add(const Made& more);
};

/// A text that was written.
struct DrawTarget {
  std::string file;
  std::string language;
  std::string flavour;  ///< of G-code
  std::uint64_t bytes = 0;
  double deviation_mm = 0;
  std::vector<std::string> lost;
};

/// All that is told of a drawing. What it refers to must outlive it.
struct DrawFacts {
  std::vector<std::string> files;  ///< names, by the drawing's FileIds
  const drawing::Drawing& drawing;
  const drawing::Cleaned& cleaned;
  std::vector<drawing::Nest> nests;  ///< of the chains
  std::vector<std::string> texts;
  const process::Plan* plan = nullptr;  ///< null: nothing was planned
  Made made;
  std::vector<Made> made_by_operation;
  std::vector<DrawTarget> targets;
  std::vector<drawing::Finding> findings;
  std::vector<std::string> assumed;
};

}  // namespace kerf::output
