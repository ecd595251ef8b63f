#pragma once

#include <optional>
#include <string>

#include "base/source_file.hpp"
#include "features/recognition.hpp"
#include "output/reports/run_facts.hpp"
#include "stock/cutting/workpiece.hpp"

namespace kerf::output {

/// What a program machines, as reports tell it. What it points to outlives it.
struct FeatureFacts {
  struct Blank {
    std::string shape;        ///< "box", "cylinder", "bar", "mesh"
    bool is_assumed = false;  ///< nobody has said what lies on the table
    stock::Bounds extents;    ///< frame of the stock
  };

  RunFacts run;
  features::Method method = features::Method::both;
  std::optional<Blank> blank;  ///< none: nothing is cut, and nobody has said
  bool tells_loops = true;     ///< their contours; false: those are empty
  const features::Recording* recording = nullptr;
  const features::Tree* tree = nullptr;
  const base::SourceSet* sources = nullptr;
};

}  // namespace kerf::output
