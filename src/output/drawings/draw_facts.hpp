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

/// A picture that is burnt.
struct RasterFacts {
  std::string file;
  std::uint32_t pixels_across = 0;
  std::uint32_t pixels_up = 0;
  double width_mm = 0;
  double height_mm = 0;
  std::size_t rows = 0;
  std::size_t burnt = 0;
  std::size_t runs = 0;
};

/// All that is told of a drawing. What it refers to must outlive it.
struct DrawFacts {
  std::vector<std::string> files;  ///< names, by the drawing's FileIds
  const drawing::Drawing& drawing;
  const drawing::Cleaned& cleaned;
  std::vector<drawing::Nest> nests;  ///< of the chains
  std::vector<std::string> texts;
  std::vector<RasterFacts> rasters;
  const process::Plan* plan = nullptr;  ///< null: nothing was planned
  Made made;
  std::vector<Made> made_by_operation;
  std::vector<DrawTarget> targets;
  std::vector<drawing::Finding> findings;
  std::vector<std::string> assumed;
};

}  // namespace kerf::output
