#include <algorithm>
#include <cmath>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "process/along.hpp"
#include "process/internal/scanlines.hpp"
#include "process/passes.hpp"

namespace kerf::process {
namespace {

using contour::Contour;
using contour::Region;

std::vector<Outline> closed_ones(const Taken& taken, std::vector<Remark>& remarks) {
  std::vector<Outline> closed;
  for (const Outline& outline : taken.outlines) {
    if (outline.path.is_closed)
      closed.push_back(outline);
    else
      remarks.push_back(
          {base::Code::draw_open, true, outline.entity, "an open contour has no inside"});
  }
  return closed;
}

drawing::EntityId first_of(const std::vector<Outline>& outlines) {
  return outlines.empty() ? 0 : outlines.front().entity;
}

void add_lines(const Operation& operation, const Settled& settled,
               const std::vector<Outline>& outlines, double angle_deg, double run_up,
               Passes& made) {
  Scan scan{
      hatched(outlines, {settled.spacing, angle_deg, operation.inset, operation.bidirectional}),
      operation.overscan.value_or(run_up)};
  if (scan.lines.empty()) return;
  made.scan_lines += scan.lines.size();
  made.passes.push_back({outlines.front().number, first_of(outlines), {}, std::move(scan)});
}

/// Each outline toggles what is inside, unless its entity says otherwise.
Region region_of(const std::vector<Outline>& outlines) {
  Region region;
  for (const Outline& outline : outlines)
    region = symmetric_difference(region, contour::region_of(outline.path));
  return region;
}

void add_offsets(const Settled& settled, const Operation& operation,
                 const std::vector<Outline>& outlines, Passes& made) {
  const Region region = region_of(outlines);
  for (double k = 0;; ++k) {
    const Region inner = contour::offset(region, -(k + 0.5) * settled.spacing - operation.inset);
    if (inner.is_empty()) return;
    for (const Contour& loop : inner.loops) {
      Along along{loop, {}, {}, false};
      along.starts = starts_of(loop, operation.start, made.rules);
      made.passes.push_back({outlines.front().number, first_of(outlines), {}, std::move(along)});
    }
  }
}

void add_outlines(const Operation& operation, const std::vector<Outline>& outlines, Passes& made) {
  for (const Outline& outline : outlines) {
    Along along{outline.path, {}, {}, false};
    along.starts = starts_of(outline.path, operation.start, made.rules);
    made.passes.push_back({outline.number, outline.entity, {}, std::move(along)});
  }
}

}  // namespace

Passes fill_passes(const Operation& operation, const Settled& settled, const Taken& taken,
                   double run_up) {
  Passes made;
  made.rules.weave = operation.weave;
  const std::vector<Outline> outlines = closed_ones(taken, made.remarks);
  if (outlines.empty()) return made;
  if (operation.fill_kind == FillKind::offset && operation.process == Process::fill) {
    add_offsets(settled, operation, outlines, made);
  } else {
    add_lines(operation, settled, outlines, operation.angle_deg, run_up, made);
    if (operation.cross)
      add_lines(operation, settled, outlines, operation.angle_deg + 90, run_up, made);
  }
  if (operation.outline) add_outlines(operation, outlines, made);
  return made;
}

}  // namespace kerf::process
