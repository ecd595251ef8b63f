#pragma once

#include "drawing/image/picture.hpp"

namespace kerf::drawing {

[[nodiscard]] base::Outcome<PictureFacts> jpeg_facts(std::string_view bytes);
[[nodiscard]] base::Outcome<GreyPicture> read_jpeg(std::string_view bytes);

}  // namespace kerf::drawing
