#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/internal/plot/display_list.hpp"
#include "output/internal/plot/path_recorder.hpp"
#include "output/internal/plot/speed_recorder.hpp"
#include "output/internal/plot/speed_scale.hpp"

namespace kerf::output::plot {

/// What all parts of the sheet show: a recording, with the choices that its parts must share.
struct Subject {
  /// With `speeds` the colours of the cuts are those of their speeds, and tools have none.
  Subject(const PathRecorder& recorder, const SpeedRecorder* speeds);

  const PathRecorder& recorded;  ///< outlives this
  Path path;
  Path speeds;                            ///< the cuts with their speeds
  std::optional<SpeedScale> speed_scale;  ///< none: the colours are those of the tools
  double tolerance;                       ///< mm; 0: nothing was simplified
  Box3 box;  ///< what the views show; never empty, never flat in X and Y at once
  std::vector<Color> tool_color;     ///< by index of the tool
  std::vector<std::size_t> cutters;  ///< indices of the tools that cut, in order of first use

  [[nodiscard]] bool has_cuts() const { return !cutters.empty(); }
  [[nodiscard]] std::string tool_name(std::size_t tool) const;
  /// X words are lengths times this: 2 for diameters.
  [[nodiscard]] double x_factor() const { return 1 / recorded.x_scale(); }
};

}  // namespace kerf::output::plot
