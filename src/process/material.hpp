#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/recipe.hpp"

namespace kerf::process {

/// What a process does to a material: starting values, to be tried on scrap.
struct Preset {
  Process process = Process::cut;
  std::optional<double> power_w;
  std::optional<double> feed;
  std::optional<double> kerf;
  std::optional<std::uint32_t> passes;
  std::optional<double> frequency_hz;
  std::optional<double> pierce_s;
  std::optional<double> focus;
  std::optional<double> spacing;
  std::optional<double> track_width;
  std::optional<double> depth;
  std::string gas;
};

struct Material {
  std::string name;
  std::string text;
  std::optional<double> thickness;
  std::vector<Preset> presets;
};

}  // namespace kerf::process
