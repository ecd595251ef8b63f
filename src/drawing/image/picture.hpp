#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace kerf::drawing {

enum class PictureKind : std::uint8_t { png, jpeg };

/// What a picture says of itself before its pixels.
struct PictureFacts {
  struct Density {
    double across = 0;  ///< pixels a mm, > 0
    double down = 0;
  };
  PictureKind kind{};
  std::uint32_t width = 0;  ///< pixels, > 0
  std::uint32_t height = 0;
  std::optional<Density> density;  ///< pHYs or JFIF; none: it does not say, or only how wide a
                                   ///< pixel is for its height
};

inline constexpr std::uint64_t kMostPixels = 100'000'000;

/// Grey values row by row from the top: 0 is black, 255 white.
struct GreyPicture {
  PictureFacts facts;
  std::vector<std::uint8_t> pixels;
};

/// The kind that the first bytes tell.
[[nodiscard]] std::optional<PictureKind> picture_kind(std::string_view bytes);

/// A failure's sentence says what is wrong: neither PNG nor JPEG, damaged, more than kMostPixels.
[[nodiscard]] base::Outcome<PictureFacts> picture_facts(std::string_view bytes);

/// (299 R + 587 G + 114 B) / 1000 of the stored values, over white as far as they are transparent,
/// to 255, rounded half up. A byte of memory for a pixel and one row; a JPEG that comes in several
/// scans needs those of libjpeg. What is cut off or damaged is a failure.
[[nodiscard]] base::Outcome<GreyPicture> read_grey(std::string_view bytes);

}  // namespace kerf::drawing
