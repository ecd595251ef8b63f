#include "job/drawing/image_sizes.hpp"

#include <algorithm>
#include <optional>

#include "drawing/image/picture.hpp"

namespace kerf::job {
namespace {

using geometry::Vec2;

constexpr double kMmAnInch = 25.4;

/// One measure gives the other by the aspect.
std::optional<Vec2> size_of(const process::ImageWords& words, const drawing::PictureFacts& facts) {
  const double across = facts.width;
  const double up = facts.height;
  if (words.width && words.height) return Vec2{*words.width, *words.height};
  if (words.width) return Vec2{*words.width, *words.width * up / across};
  if (words.height) return Vec2{*words.height * across / up, *words.height};
  if (words.dpi) return (kMmAnInch / *words.dpi) * Vec2{across, up};
  return std::nullopt;
}

bool is_file(const drawing::Drawing& drawing, base::FileId file) {
  return std::any_of(drawing.files.begin(), drawing.files.end(), [&](const auto& facts) {
    return facts.file == file && facts.format == "image";
  });
}

}  // namespace

void size_images(const process::ImageWords& words, drawing::Drawing& drawing) {
  for (drawing::Image& image : drawing.images) {
    const base::FileId file = drawing.entities[image.entity].file;
    if (!is_file(drawing, file)) continue;
    const auto facts = drawing::picture_facts(image.bytes);
    if (!facts) continue;
    const std::optional<Vec2> size = size_of(words, *facts);
    if (!size) continue;
    image.to_mm = {{size->u, 0}, {0, size->v}, {}};
    image.size_is_known = true;
    std::erase_if(drawing.findings, [&](const drawing::Finding& finding) {
      return finding.diagnostic.code == base::Code::draw_unit &&
             finding.diagnostic.place.file == file;
    });
  }
}

}  // namespace kerf::job
