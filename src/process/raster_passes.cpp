#include <cmath>

#include "drawing/image/picture.hpp"
#include "process/passes.hpp"
#include "process/raster.hpp"

namespace kerf::process {
namespace {

using drawing::Affine;

/// The picture's own plane, mm, brought to where the unit square lies; without shear.
Affine from_picture(const Affine& placed, Vec2 size) {
  return {(1 / size.u) * placed.x, (1 / size.v) * placed.y, placed.shift};
}

std::shared_ptr<const GreyImage> pixels_of(const drawing::Image& image, Passes& made) {
  auto read = drawing::read_grey(image.bytes);
  if (!read) {
    made.remarks.push_back({base::Code::image_bad, true, image.entity, read.error().message});
    return nullptr;
  }
  auto grey = std::make_shared<GreyImage>();
  grey->width = read->facts.width;
  grey->height = read->facts.height;
  grey->pixels = std::move(read->pixels);
  return grey;
}

/// Made once beforehand: how much there is, where it begins and where it ends.
void count(Raster raster, const Picture& picture, RasterFacts& facts, Entry& entry) {
  facts.columns = raster.columns();
  facts.rows = raster.rows();
  ScanLine line;
  while (raster.next(line)) {
    const auto at = [&](double along) { return picture.placed(line.origin + along * line.along); };
    if (facts.lines++ == 0) entry.begin = at(line.runs.front().from - picture.run_up);
    entry.end = at(line.runs.back().to + picture.run_up);
  }
  facts.burnt = raster.burnt();
  facts.runs = raster.runs();
}

void add(const PlacedImage& placed, const Operation& operation, const Settled& settled,
         const MachineFacts& machine, Passes& made) {
  const drawing::EntityId entity = placed.image->entity;
  Picture picture;
  picture.image = pixels_of(*placed.image, made);
  if (!picture.image) return;
  picture.operation = operation;
  picture.settled = settled;
  picture.size_mm = {geometry::length(placed.placed.x), geometry::length(placed.placed.y)};
  picture.placed = from_picture(placed.placed, picture.size_mm);
  picture.run_up = operation.overscan.value_or(run_up_mm(machine, settled.feed, picture.placed.x));
  auto raster = Raster::make(*picture.image, operation, settled, picture.size_mm);
  if (!raster) {
    made.remarks.push_back({raster.error().code, true, entity, raster.error().message});
    return;
  }
  RasterFacts facts;
  facts.entity = entity;
  facts.size_mm = picture.size_mm;
  count(std::move(*raster), picture, facts, picture.entry);
  made.rasters.push_back(facts);
  made.scan_lines += facts.lines;
  if (facts.lines > 0) made.passes.push_back({kNoContour, entity, {}, std::move(picture)});
}

}  // namespace

Passes raster_passes(const Operation& operation, const Settled& settled, const Taken& taken,
                     const MachineFacts& machine) {
  Passes made;
  for (const PlacedImage& image : taken.images) add(image, operation, settled, machine, made);
  for (const Outline& outline : taken.outlines)
    made.remarks.push_back({base::Code::draw_image, false, outline.entity,
                            "a contour is no picture: raster leaves it out"});
  return made;
}

}  // namespace kerf::process
