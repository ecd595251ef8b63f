#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <tl/expected.hpp>

#include "base/result.hpp"
#include "job/edit_result.hpp"
#include "job/edit_scene.hpp"
#include "output/features/edit_preview.hpp"

namespace kerf::job {

/// Up to where edits are tried: whether their contours are sound, whether they can be cut and
/// merged, whether the merged program does what was asked.
enum class PreviewUntil : std::uint8_t { contour, paths, verified };

/// Tries edits (the text of an edits file) on a scene. What is refused is a problem, and the
/// contours are told all the same. Whoever stops `unwanted` gets what there is by then. Failures
/// as recognise_features() has them.
[[nodiscard]] base::Outcome<output::EditPreview> preview_edits(const EditScene& scene,
                                                               const std::string& edits,
                                                               PreviewUntil until,
                                                               const std::stop_token& unwanted);

/// Makes them, as edit_features() does; the error of the inner one is why they are refused.
using MadeEdit = tl::expected<EditResult, output::EditPreview::Problem>;
[[nodiscard]] base::Outcome<MadeEdit> make_edits(const EditScene& scene, const std::string& edits,
                                                 const std::stop_token& unwanted);

}  // namespace kerf::job
