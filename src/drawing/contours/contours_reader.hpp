#pragma once

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::drawing {

/// Draws contours as contours_json.cpp writes them:
/// {"unit":"mm","layers":[{"name","colour","contours":[{"closed":true,"points":[[x,y,bulge],…]}]}]}.
/// Members may come in any order; others are passed over. `unit` is mm where it is missing,
/// `colour` black, `closed` false, a bulge 0. Finding: CONTOURS_FILE with line and column; what is
/// whole in front of it is drawn all the same.
void read_contours(const base::SourceFile& file, base::FileId id, Canvas& canvas);

}  // namespace kerf::drawing
