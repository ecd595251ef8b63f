#include "control/coordinates.hpp"

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisVector;

}  // namespace

AxisVector Coordinates::tidied(AxisVector point) const {
  for (std::size_t i = 0; i < axes_.count(); ++i) point.values[i] = base::tidy(point.values[i]);
  return point;
}

AxisVector Coordinates::path_of(const AxisVector& program) const {
  if (plain_) return program;
  return tidied((transform_.identity() ? program : transform_.apply(program)) + origin_);
}

void Coordinates::arrive_at(const AxisVector& path) {
  path_ = path;
  const AxisVector work = path - origin_;
  program_ = tidied(transform_.identity() ? work : transform_.invert(work));
}

void Coordinates::refresh_origin() {
  const AxisVector& offset =
      work_.extended != 0 ? memory_.extended[work_.extended - 1] : memory_.work[work_.index];
  const AxisVector before = origin_;
  origin_ = tidied(memory_.external + offset + local_ + shift_);
  program_ = tidied(program_ + before - origin_);
  plain_ = transform_.identity() && origin_ == AxisVector{};
}

void Coordinates::select(const WorkSystem& work) {
  work_ = work;
  refresh_origin();
}

void Coordinates::offsets_changed() { refresh_origin(); }

void Coordinates::set_local(Axis axis, double shift) {
  local_[axis] = shift;
  refresh_origin();
}

void Coordinates::preset(Axis axis, double value) {
  shift_[axis] += program_[axis] - value;
  refresh_origin();
}

void Coordinates::clear_shifts(Axis axis) {
  local_[axis] = 0;
  shift_[axis] = 0;
  refresh_origin();
}

void Coordinates::set_transform(const Transform& transform) {
  const bool cancels = transform.identity() && !transform_.identity();
  transform_ = transform;
  if (cancels) program_ = tidied(path_ - origin_);
  plain_ = transform_.identity() && origin_ == AxisVector{};
}

}  // namespace kerf::control
