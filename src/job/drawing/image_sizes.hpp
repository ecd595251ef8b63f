#pragma once

#include "drawing/drawing.hpp"
#include "process/recipe.hpp"

namespace kerf::job {

/// Pictures that are files of their own are as large as [image] says; what was told of a size that
/// their file does not say is taken back then.
void size_images(const process::ImageWords& words, drawing::Drawing& drawing);

}  // namespace kerf::job
