#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/crossing.hpp"
#include "geometry/contour/offset.hpp"
#include "process/along.hpp"
#include "process/internal/lead_clearance.hpp"
#include "process/internal/sharp_corners.hpp"
#include "process/passes.hpp"

namespace kerf::process {
namespace {

using contour::Contour;
using contour::Region;

/// On which side of a contour the beam goes, as the part wants it: it lies to the left of its
/// contours, outer ones counterclockwise, holes clockwise.
enum class Goes : std::uint8_t { on, outside, inside };

Goes side_of(const Operation& operation, const Contour& path, std::size_t depth) {
  switch (operation.side) {
    case CutSide::automatic: break;
    case CutSide::outside: return Goes::outside;
    case CutSide::inside: return Goes::inside;
    case CutSide::on: return Goes::on;
  }
  if (!path.is_closed) return Goes::on;
  return depth % 2 == 0 ? Goes::outside : Goes::inside;
}

/// The loops that the middle of the beam goes along; none: the hole is narrower than the beam.
std::vector<Contour> compensated(const Contour& path, Goes goes, double kerf, CutCorner corner) {
  if (goes == Goes::on || kerf <= 0) return {path};
  const Region inside = contour::region_of(path);
  Region moved = contour::offset(inside, goes == Goes::outside ? 0.5 * kerf : -0.5 * kerf);
  if (corner == CutCorner::sharp && goes == Goes::outside)
    for (Contour& loop : moved.loops) loop = with_sharp_corners(loop, path, kerf);
  return std::move(moved.loops);
}

bool runs_as_hole(Goes goes, std::size_t depth) {
  return goes == Goes::inside || (goes == Goes::on && depth % 2 == 1);
}

/// Holes are gone round clockwise.
Contour directed(Contour path, Goes goes, std::size_t depth) {
  if (!path.is_closed) return path;
  if (is_counterclockwise(path) == runs_as_hole(goes, depth)) return reversed(path);
  return path;
}

AlongRules rules_of(const Operation& operation, const Settled& settled) {
  AlongRules rules;
  rules.lead_in = operation.lead_in;
  rules.lead_out = operation.lead_out;
  rules.leads_open = operation.lead_open;
  rules.overcut = settled.overcut;
  rules.pierce_s = operation.pierce_s;
  rules.tabs = operation.tabs;
  rules.kerf = settled.kerf;
  return rules;
}

class Cutting {
 public:
  Cutting(const Operation& operation, const Settled& settled, const Taken& taken)
      : operation_(operation), settled_(settled), taken_(taken) {
    made_.rules = rules_of(operation, settled);
    for (const Outline& outline : taken.outlines) paths_.push_back(outline.path);
    nests_ = drawing::nests_of(paths_);
  }

  Passes made() {
    tell_crossings();
    of_outline_.resize(taken_.outlines.size());
    for (std::size_t i = 0; i < taken_.outlines.size(); ++i) add(i);
    put_inner_first();
    shorten_leads(made_.passes, made_.rules, made_.remarks);
    return std::move(made_);
  }

 private:
  void tell_crossings() {
    if (settled_.kerf <= 0 || operation_.side == CutSide::on) return;
    std::vector<Contour> closed;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (!paths_[i].is_closed) continue;
      closed.push_back(paths_[i]);
      numbers.push_back(i);
    }
    const auto meeting = contour::meeting_of(closed, 1e-6);
    if (!meeting || !meeting->is_crossing) return;
    const Outline& outline = taken_.outlines[numbers[meeting->first.contour]];
    made_.remarks.push_back(
        {base::Code::draw_crossing, true, outline.entity,
         fmt::format("at X{:.3f} Y{:.3f}", meeting->point.u, meeting->point.v)});
  }

  void add(std::size_t i) {
    const Outline& outline = taken_.outlines[i];
    const std::size_t depth = nests_[i].depth;
    const Goes goes = side_of(operation_, outline.path, depth);
    if (goes != Goes::on && !outline.path.is_closed) {
      made_.remarks.push_back({base::Code::draw_open, true, outline.entity,
                               "an open contour has no inside and no outside"});
      return;
    }
    std::vector<Contour> loops = compensated(outline.path, goes, settled_.kerf, operation_.corner);
    if (loops.empty())
      made_.remarks.push_back({base::Code::kerf_too_wide, false, outline.entity,
                               fmt::format("kerf {:.6g} mm", settled_.kerf)});
    for (Contour& loop : loops) {
      of_outline_[i].push_back(static_cast<std::uint32_t>(made_.passes.size()));
      Along along{directed(std::move(loop), goes, depth), {}, {}, false};
      along.scrap_is_left = false;
      along.starts = starts_of(along.path, operation_.start, made_.rules);
      made_.passes.push_back({outline.number, outline.entity, {}, std::move(along)});
    }
  }

  void put_first(const std::vector<std::uint32_t>& inner, const std::vector<std::uint32_t>& outer) {
    for (const std::uint32_t pass : outer)
      for (const std::uint32_t earlier : inner) made_.passes[pass].before.push_back(earlier);
  }

  void put_inner_first() {
    for (std::size_t i = 0; i < nests_.size(); ++i) {
      if (nests_[i].parent) put_first(of_outline_[i], of_outline_[*nests_[i].parent]);
    }
  }

  const Operation& operation_;
  const Settled& settled_;
  const Taken& taken_;
  std::vector<Contour> paths_;
  std::vector<drawing::Nest> nests_;
  std::vector<std::vector<std::uint32_t>> of_outline_;  // passes
  Passes made_;
};

}  // namespace

Passes cut_passes(const Operation& operation, const Settled& settled, const Taken& taken) {
  return Cutting(operation, settled, taken).made();
}

}  // namespace kerf::process
