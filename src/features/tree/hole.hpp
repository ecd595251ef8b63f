#pragma once

#include <optional>
#include <string>
#include <vector>

#include "features/tree/feature.hpp"
#include "features/tree/hole_step.hpp"

namespace kerf::features {

struct HoleThread {
  double pitch = 0;
  double diameter = 0;
};

struct Hole {
  enum class Form : std::uint8_t {
    plain,
    spot,
    counterbore,
    countersink,
    stepped,
    tapped,
    threaded
  };
  Form form = Form::plain;
  std::string key{};
  std::size_t setup = 0;
  std::uint32_t tool = 0;  ///< of the first step
  std::optional<Relation> parent{};
  Vec2 at{};
  double diameter = 0;
  double top = 0;
  double bottom = 0;
  bool through = false;
  double volume = 0;
  std::optional<std::size_t> pattern{};
  std::optional<HoleThread> thread{};
  std::vector<HoleStep> steps{};
  Origin origin{};
  Editable editable = Editable::contour;
  double confidence = 1;
  std::vector<Reason> reasons{};
};

/// Holes of the same steps that belong together.
struct Pattern {
  enum class Kind : std::uint8_t { line, grid, circle, list };
  Kind kind = Kind::list;
  std::vector<std::size_t> holes{};  ///< places among the holes
  std::optional<double> pitch{};     ///< of a line; of a grid along its rows
  std::optional<double> second_pitch{};
  std::optional<double> angle_deg{};
  std::optional<Vec2> centre{};
  std::optional<double> radius{};
  std::optional<double> start_deg{};
};

}  // namespace kerf::features
