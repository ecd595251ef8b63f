#pragma once

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"
#include "drawing/svg/internal/tree.hpp"

namespace kerf::drawing::svg {

/// Elements may be so deep in each other.
inline constexpr std::size_t kDeepest = 256;

/// The tree of a file; what is wrong is told as SVG_XML or SVG_ENTITY, and what stands before it is
/// in the tree all the same. Entities expand to no more than 1 MiB, and none is opened.
[[nodiscard]] Tree read_tree(const base::SourceFile& file, Canvas& canvas);

}  // namespace kerf::drawing::svg
