#include "job/internal/left_solid.hpp"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "job/internal/stock_models.hpp"
#include "job/stock_part.hpp"
#include "math/math.hpp"
#include "stock/compare/dexel_solid.hpp"
#include "stock/compare/field_solid.hpp"
#include "stock/compare/plate_solid.hpp"
#include "stock/compare/turned_solid.hpp"
#include "stock/field/height_field.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::job {
namespace {

using contour::Vec2;
using stock::Vec3;
using stock::compare::Part;
using stock::compare::Solid;

/// Outer loops with their holes.
std::vector<contour::Region> pieces_apart(const contour::Region& region) {
  const auto parents = contour::parents(region);
  std::vector<contour::Region> pieces;
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    if (!contour::is_counterclockwise(region.loops[i])) continue;
    contour::Region piece{{region.loops[i]}};
    for (std::size_t k = 0; k < region.loops.size(); ++k) {
      const bool is_hole = parents[k] == i && !contour::is_counterclockwise(region.loops[k]);
      if (is_hole) piece.loops.push_back(region.loops[k]);
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Most of what of a grid of places lies in the piece lies in the design, too.
bool lies_in(const contour::Region& piece, const Solid& design) {
  constexpr int kPlaces = 40;  // along a side
  const stock::compare::Outline outline(piece, stock::compare::Outline::OnAxis::is_surface);
  const contour::Box& box = outline.box();
  int places = 0;
  int in_design = 0;
  std::vector<stock::compare::Stretch> found;
  for (int i = 0; i < kPlaces * kPlaces; ++i) {
    const double u = (i % kPlaces + 0.5) / kPlaces;
    const double v = (i / kPlaces + 0.5) / kPlaces;
    const Vec2 place{box.low.u + u * (box.high.u - box.low.u),
                     box.low.v + v * (box.high.v - box.low.v)};
    if (!outline.holds(place)) continue;
    found.clear();
    design.inside(2, place.u, place.v, found);
    ++places;
    in_design += found.empty() ? 0 : 1;
  }
  return 2 * in_design > places;
}

Vec3 in_half_plane(Vec3 place) { return {math::hypot(place.x, place.y), 0, place.z}; }

}  // namespace

std::unique_ptr<Part> solid_of(const stock::Model& model, const stock::Bounds& piece) {
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(&model))
    return std::make_unique<stock::compare::FieldSolid>(*field);
  if (const stock::dexel::TriDexel* const dexels = dexels_of(model))
    return std::make_unique<stock::compare::DexelSolid>(*dexels);
  return std::make_unique<stock::compare::TurnedSolid>(
      dynamic_cast<const stock::turned::TurnedPart&>(model).region(), piece);
}

std::unique_ptr<Part> plate_of(const contour::Region& pieces, const stock::Bounds& sheet) {
  return std::make_unique<stock::compare::PlateSolid>(pieces, sheet);
}

std::unique_ptr<Part> solid_of(const StockResult& result) {
  if (result.model) return solid_of(*result.model, stock::bounds(result.shape));
  return plate_of(*cut_pieces_of(result), stock::bounds(result.shape));
}

std::unique_ptr<Part> solid_of(const StockResult& result, const Solid& design) {
  if (result.model) return solid_of(*result.model, stock::bounds(result.shape));
  contour::Region wanted;
  for (contour::Region& piece : pieces_apart(*cut_pieces_of(result))) {
    if (!lies_in(piece, design)) continue;
    for (contour::Contour& loop : piece.loops) wanted.loops.push_back(std::move(loop));
  }
  return plate_of(wanted, stock::bounds(result.shape));
}

unsigned threads_for(const StockJob& job) {
  return job.jobs > 0 ? job.jobs : std::max(1U, std::thread::hardware_concurrency());
}

stock::compare::Comparison compared(const StockJob& job, const StockResult& result,
                                    const Part& part, const Solid& wanted) {
  auto found = stock::compare::compare(part, wanted, job.tolerance, threads_for(job));
  if (profile_of(result) == nullptr) return found;
  for (stock::compare::Region& region : found.regions) {
    region.at = in_half_plane(region.at);
    region.centre = in_half_plane(region.centre);
  }
  return found;
}

}  // namespace kerf::job
