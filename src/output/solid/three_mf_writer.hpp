#pragma once

#include <string>

#include "base/result.hpp"
#include "output/solid/solid_file.hpp"

namespace kerf::output {

/// A 3MF file, which is a ZIP: an object a piece, mm, triangles coloured by their materials.
/// Without dates. Failure (output): the archive cannot be made.
[[nodiscard]] base::Outcome<std::string> three_mf_of(const SolidFile& file);

}  // namespace kerf::output
