#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/picture/drawing/display_list.hpp"
#include "output/picture/internal/cut_recorder.hpp"
#include "output/picture/internal/cut_scale.hpp"
#include "output/picture/internal/path_recorder.hpp"

namespace kerf::output::plot {

/// What all parts of the sheet show: a recording, with the choices that its parts must share.
struct Subject {
  /// With `cuts` the colours of the cuts are those of their values, and tools have none.
  Subject(const PathRecorder& recorder, const CutRecorder* cuts);

  const PathRecorder& recorded;  ///< outlives this
  Path path;
  Path values;                        ///< the cuts with what their colours say
  std::optional<CutScale> cut_scale;  ///< none: the colours are those of the tools
  std::string cut_caption;
  double tolerance;  ///< mm; 0: nothing was simplified
  Box3 box;          ///< what the views show; never empty, never flat in X and Y at once
  std::vector<Color> tool_color;     ///< by index of the tool
  std::vector<std::size_t> cutters;  ///< indices of the tools that cut, in order of first use

  [[nodiscard]] bool has_cuts() const { return !cutters.empty(); }
  [[nodiscard]] std::string tool_name(std::size_t tool) const;
  /// X words are lengths times this: 2 for diameters.
  [[nodiscard]] double x_factor() const { return recorded.turns() ? 2 : 1; }
};

}  // namespace kerf::output::plot
