#include "drawing/image/read_image.hpp"

#include <fmt/format.h>

#include "drawing/image/picture.hpp"
#include "drawing/units.hpp"

namespace kerf::drawing {
namespace {

constexpr std::uint64_t kMostBytes = 256U << 20U;

std::string bytes_of(const base::SourceFile& file) {
  std::string bytes(static_cast<std::size_t>(std::min(file.size(), kMostBytes)), 0);
  bytes.resize(file.read(0, bytes));
  return bytes;
}

std::string_view last_part(std::string_view path) {
  return path.substr(path.find_last_of('/') + 1);  // of no slash: all
}

void tell_size(FileFacts& facts, std::string unit, std::string from, double pixel_mm) {
  facts.unit = std::move(unit);
  facts.unit_from = std::move(from);
  facts.scale_mm = pixel_mm;
}

/// A pixel's width and height, mm; tells what says so.
Vec2 pixel_of(const PictureFacts& picture, const Reading& reading, FileFacts& facts) {
  const double dpi = reading.dpi > 0 ? reading.dpi : kDpi;
  Vec2 pixel{kMmAnInch / dpi, kMmAnInch / dpi};
  if (const auto unit = mm_of_unit(reading.unit, dpi)) {
    pixel = {*unit, *unit};
    tell_size(facts, reading.unit, "--unit", pixel.u);
  } else if (reading.dpi > 0) {
    tell_size(facts, "px", "--dpi", pixel.u);
  } else if (picture.density) {
    pixel = {1 / picture.density->across, 1 / picture.density->down};
    tell_size(facts, "px", picture.kind == PictureKind::png ? "pHYs" : "JFIF", pixel.u);
  } else {
    tell_size(facts, "px", "assumed", pixel.u);
  }
  return pixel;
}

}  // namespace

void read_image(const base::SourceFile& file, base::FileId id, Canvas& canvas) {
  FileFacts& facts = canvas.begin_file(id, "image");
  const std::string_view layer = last_part(file.name());
  if (!canvas.wants(layer)) return;
  std::string bytes = bytes_of(file);
  const auto picture = picture_facts(bytes);
  const base::Place place{id, 1, 1};
  if (!picture)
    return canvas.find(base::Severity::error, base::Code::image_bad, place,
                       picture.error().message);
  facts.version = picture->kind == PictureKind::png ? "PNG" : "JPEG";
  const Vec2 pixel = pixel_of(*picture, canvas.reading(), facts);
  Entity entity;
  entity.line = 1;
  entity.layer = canvas.name(layer);
  entity.kind = canvas.name("image");
  Image image;
  image.to_mm = Affine::scaled(picture->width * pixel.u, picture->height * pixel.v);
  image.size_is_known = facts.unit_from != "assumed";
  image.bytes = std::move(bytes);
  image.entity = canvas.add(entity);
  if (!image.size_is_known)
    canvas.find(base::Severity::warning, base::Code::draw_unit, place,
                fmt::format("the picture does not say how large its pixels are: {} dpi", kDpi),
                entity.layer, entity.kind, "--dpi says it");
  canvas.add(std::move(image));
}

}  // namespace kerf::drawing
