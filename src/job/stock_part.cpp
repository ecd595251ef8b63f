#include "job/stock_part.hpp"

#include <algorithm>
#include <utility>

#include "geometry/contour/boolean.hpp"
#include "job/internal/stock_models.hpp"
#include "stock/field/height_field.hpp"
#include "stock/saved/saved_sheet.hpp"
#include "stock/sheet/outline.hpp"
#include "stock/surface/contouring.hpp"
#include "stock/surface/dexel_samples.hpp"
#include "stock/surface/height_samples.hpp"
#include "stock/surface/height_steps.hpp"
#include "stock/surface/plate_surface.hpp"
#include "stock/surface/simplify.hpp"
#include "stock/surface/turned_surface.hpp"
#include "stock/turnmill/turn_mill_part.hpp"

namespace kerf::job {
namespace {

using stock::Vec3;
using stock::surface::Surface;

contour::Region rectangle(const stock::Bounds& box) {
  return {{{.vertices = {{{box.low.x, box.low.y}},
                         {{box.high.x, box.low.y}},
                         {{box.high.x, box.high.y}},
                         {{box.low.x, box.high.y}}}}}};
}

/// Every so many points of a lattice.
int stride_for(int most_points, const SurfaceWish& wish) {
  if (wish.most_along == 0) return 1;
  const auto most = static_cast<int>(wish.most_along);
  return std::max(1, (most_points + most - 1) / most);
}

Surface surface_of(const stock::dexel::TriDexel& model, const SurfaceWish& wish) {
  int most = 0;
  for (int grid = 0; grid < 3; ++grid) most = std::max(most, model.lattice(grid).columns);
  const stock::surface::DexelSamples samples(model, stride_for(most, wish));
  return stock::surface::Contouring(samples).surface(wish.jobs);
}

Surface surface_of(const stock::field::HeightField& model, const SurfaceWish& wish) {
  const stock::field::Grid& grid = model.columns().grid();
  if (wish.steps) return stock::surface::height_steps(model.columns());
  const int stride = stride_for(std::max(grid.nx, grid.ny), wish);
  const stock::surface::HeightSamples samples(model.columns(), stride);
  return stock::surface::Contouring(samples).surface(wish.jobs);
}

/// From Z as its axis to another: the axes change places in a circle, so nothing is mirrored.
Vec3 laid(Vec3 p, int along) {
  if (along == 0) return {p.z, p.x, p.y};
  if (along == 1) return {p.y, p.z, p.x};
  return p;
}

Surface cylinder(const stock::CylinderShape& round, double chord_mm) {
  const contour::Region bar =
      stock::turned::bar(round.diameter, round.from, round.to, round.inner_diameter);
  Surface surface = stock::surface::turned(bar, chord_mm);
  const Vec3 middle = round.along == 0   ? Vec3{0, round.u, round.v}
                      : round.along == 1 ? Vec3{round.u, 0, round.v}
                                         : Vec3{round.u, round.v, 0};
  for (Vec3& p : surface.mesh.points) p = laid(p, round.along) + middle;
  return surface;
}

}  // namespace

Surface surface_of(const stock::Workpiece& shape, double chord_mm) {
  if (const auto* const round = std::get_if<stock::CylinderShape>(&shape))
    return cylinder(*round, chord_mm);
  if (const auto* const solid = std::get_if<stock::MeshShape>(&shape)) {
    const mesh::TriangleMesh& triangles = solid->solid->mesh;
    return {triangles, std::vector<std::uint32_t>(triangles.triangles.size()),
            std::vector<std::uint32_t>(triangles.points.size())};
  }
  if (const auto* const saved = std::get_if<stock::SavedShape>(&shape))
    return surface_of(stock::Workpiece(saved->part->solid()), chord_mm);
  const stock::Bounds box = stock::bounds(shape);
  return stock::surface::plate(rectangle(box), box.low.z, box.high.z, chord_mm);
}

namespace {

Surface whole_surface_of(const StockResult& result, const SurfaceWish& wish) {
  const stock::Model* const model = result.model.get();
  const stock::dexel::TriDexel* const dexels = model == nullptr ? nullptr : dexels_of(*model);
  if (dexels != nullptr) return surface_of(*dexels, wish);
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(model))
    return surface_of(*field, wish);
  if (const contour::Region* const profile = profile_of(result))
    return stock::surface::turned(*profile, wish.chord_mm);
  const stock::Bounds sheet = stock::bounds(result.shape);
  return stock::surface::plate(*pieces_of(result), sheet.low.z, sheet.high.z, wish.chord_mm);
}

}  // namespace

Surface surface_of(const StockResult& result, const SurfaceWish& wish) {
  Surface whole = whole_surface_of(result, wish);
  return wish.triangles > 0 ? stock::surface::simplified(std::move(whole), wish.triangles) : whole;
}

namespace {

contour::Region pieces_by(const StockResult& result, std::span<const std::uint32_t> owners) {
  contour::Region sheet = rectangle(stock::bounds(result.shape));
  if (const auto* const saved = std::get_if<stock::SavedShape>(&result.shape)) {
    if (const auto* const before = dynamic_cast<const stock::saved::SavedSheet*>(saved->part.get()))
      sheet = before->left();
  }
  if (result.ways.empty()) return sheet;
  return contour::subtract(
      sheet, stock::sheet::outline_of(result.ways, result.sheet_facts->kerf_mm, owners));
}

}  // namespace

std::optional<contour::Region> pieces_of(const StockResult& result) {
  if (!result.sheet) return {};
  return pieces_by(result, {});
}

std::optional<contour::Region> cut_pieces_of(const StockResult& result) {
  if (!result.sheet) return {};
  return pieces_by(result, result.way_motions);
}

const contour::Region* profile_of(const StockResult& result) {
  const auto* const part = dynamic_cast<const stock::turned::TurnedPart*>(result.model.get());
  return part == nullptr ? nullptr : &part->region();
}

std::optional<contour::Region> outline_of(const StockResult& result) {
  if (const contour::Region* const profile = profile_of(result)) return *profile;
  using stock::turnmill::TurnMillPart;
  if (const auto* const part = dynamic_cast<const TurnMillPart*>(result.model.get()))
    return part->profile().region();
  return pieces_of(result);
}

std::optional<contour::Region> profile_of(const stock::Workpiece& shape) {
  const auto* const round = std::get_if<stock::CylinderShape>(&shape);
  if (round == nullptr || round->along != 2 || round->u != 0 || round->v != 0) return {};
  return stock::turned::bar(round->diameter, round->from, round->to, round->inner_diameter);
}

}  // namespace kerf::job
