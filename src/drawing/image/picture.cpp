#include "drawing/image/picture.hpp"

#include <fmt/format.h>

#include "drawing/image/internal/jpeg_picture.hpp"
#include "drawing/image/internal/png_picture.hpp"
#include "drawing/image/internal/size_check.hpp"

namespace kerf::drawing {
namespace {

constexpr std::string_view kPngMark("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kJpegMark("\xff\xd8\xff", 3);

tl::unexpected<base::Failure> no_picture() {
  return bad_picture("its first bytes are neither those of a PNG nor of a JPEG");
}

}  // namespace

std::optional<std::string> objection_to_size(std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) return "it has no pixels";
  if (width > kMostPixels / height)
    return fmt::format("it has {} x {} pixels; at most {} megapixels are read", width, height,
                       kMostPixels / 1'000'000);
  return std::nullopt;
}

std::optional<PictureKind> picture_kind(std::string_view bytes) {
  if (bytes.starts_with(kPngMark)) return PictureKind::png;
  if (bytes.starts_with(kJpegMark)) return PictureKind::jpeg;
  return std::nullopt;
}

base::Outcome<PictureFacts> picture_facts(std::string_view bytes) {
  const auto kind = picture_kind(bytes);
  if (!kind) return no_picture();
  return *kind == PictureKind::png ? png_facts(bytes) : jpeg_facts(bytes);
}

base::Outcome<GreyPicture> read_grey(std::string_view bytes) {
  const auto kind = picture_kind(bytes);
  if (!kind) return no_picture();
  return *kind == PictureKind::png ? read_png(bytes) : read_jpeg(bytes);
}

}  // namespace kerf::drawing
