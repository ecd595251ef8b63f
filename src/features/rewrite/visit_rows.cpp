#include "features/rewrite/visit_rows.hpp"

#include <algorithm>

#include "features/path/tolerance.hpp"
#include "features/rewrite/loop_rows.hpp"

namespace kerf::features {
namespace {

bool is_at(Vec2 a, Vec2 b) { return geometry::length(a - b) <= kSamePoint_mm; }

}  // namespace

VisitRows::VisitRows(const Recording& recording, Span visit, double z)
    : recording_(recording), visit_(visit), z_(z), at_(recording.from(visit.first)) {}

void VisitRows::put(PlannedRow row) {
  at_ = row.to;
  rows_.push_back(std::move(row));
}

void VisitRows::put_moved(std::uint32_t row, Vec2 by) {
  PlannedRow planned = as_it_is(recording_, row);
  planned.to = planned.to + Vec3{by.u, by.v, 0};
  if (planned.arc) planned.arc->centre = planned.arc->centre + by;
  put(std::move(planned));
}

void VisitRows::approach(std::uint32_t first, Vec2 start) {
  const Vec2 by = start - recording_.flat_from(first);
  for (std::uint32_t row = visit_.first; row < first; ++row) put_moved(row, by);
  at_ = {start.u, start.v, z_};
}

void VisitRows::go_straight(Vec2 to, std::uint32_t like) {
  if (!is_at(at(), to)) put({.to = {to.u, to.v, z_}, .like = like});
}

void VisitRows::go_along(const Contour& way, std::uint32_t like) {
  append_loop(way, z_, like, rows_);
  at_ = rows_.back().to;
}

void VisitRows::go_over(Vec2 start, std::uint32_t first, std::uint32_t last) {
  const double clear_z = recording_.moves[std::min(last + 1, visit_.last)].to.z;
  std::uint32_t entry = visit_.first;  // what comes behind the last rapid across
  for (std::uint32_t row = visit_.first; row < first; ++row) {
    const bool is_rapid = recording_.moves[row].kind == Move::Kind::rapid;
    if (is_rapid && !is_upright(recording_, row)) entry = row + 1;
  }
  const Vec2 by = start - recording_.flat_from(first);
  const Vec2 above = recording_.flat_from(entry) + by;
  put({.to = {at_.x, at_.y, clear_z}, .kind = Move::Kind::rapid, .like = first});
  put({.to = {above.u, above.v, clear_z}, .kind = Move::Kind::rapid, .like = first});
  for (std::uint32_t row = entry; row < first; ++row) {
    put_moved(row, by);
    rows_.back().was.reset();
  }
}

void VisitRows::go_like(Span rows, Vec2 old_from, Vec2 old_to, Vec2 to) {
  const Vec2 from = at();
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    const Vec2 end = recording_.flat_to(row);
    const Vec2 by = is_at(end, old_from) && !is_at(end, old_to) ? from - old_from : to - old_to;
    put_moved(row, by);
  }
}

void VisitRows::retract(std::uint32_t last) {
  const Vec2 by = at() - recording_.flat_to(last);
  for (std::uint32_t row = last + 1; row <= visit_.last; ++row) put_moved(row, by);
}

Stretch VisitRows::done() {
  align(recording_, visit_, recording_.from(visit_.first), rows_);
  return {visit_, std::move(rows_)};
}

}  // namespace kerf::features
