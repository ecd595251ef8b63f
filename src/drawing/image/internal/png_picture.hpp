#pragma once

#include "drawing/image/picture.hpp"

namespace kerf::drawing {

[[nodiscard]] base::Outcome<PictureFacts> png_facts(std::string_view bytes);
[[nodiscard]] base::Outcome<GreyPicture> read_png(std::string_view bytes);

}  // namespace kerf::drawing
