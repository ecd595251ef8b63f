#include "control/gcode/frames/coordinates.hpp"

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisVector;
using base::PathPoint;
using base::ProgramPoint;

}  // namespace

AxisVector Coordinates::tidied(AxisVector point) const {
  for (std::size_t i = 0; i < axes_->count(); ++i) point.values[i] = base::tidy(point.values[i]);
  return point;
}

AxisVector Coordinates::image_of(const ProgramPoint& program) const {
  return transform_.identity() ? program.numbers() : transform_.apply(program);
}

ProgramPoint Coordinates::program_of(const AxisVector& image) const {
  return ProgramPoint(tidied(transform_.identity() ? image : transform_.invert(image)));
}

PathPoint Coordinates::path_of(const ProgramPoint& program) const {
  return PathPoint(plain_ ? program.numbers() : tidied(image_of(program) + origin_));
}

void Coordinates::arrive_at(const PathPoint& path) {
  path_ = path;
  program_ = program_of(path.numbers() - origin_);
}

void Coordinates::refresh_origin() {
  const AxisVector& offset =
      work_.extended != 0 ? memory_->extended[work_.extended - 1] : memory_->work[work_.index];
  const AxisVector before = origin_;
  origin_ = tidied(axes_->in_mm(memory_->external + offset) + local_ + shift_);
  if (unrolled_) origin_[unrolled_->axis] *= unrolled_->mm_per_degree;
  if (before != origin_) program_ = program_of(image_of(program_) + before - origin_);
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

void Coordinates::preset(const ProgramPoint& program) {
  shift_ = tidied(shift_ + image_of(program_) - image_of(program));
  refresh_origin();
  program_ = program;
}

void Coordinates::clear_shifts(Axis axis) {
  local_[axis] = 0;
  shift_[axis] = 0;
  refresh_origin();
}

void Coordinates::unroll(Axis axis, double mm_per_degree) {
  unrolled_ = {axis, mm_per_degree};
  path_[axis] *= mm_per_degree;
  refresh_origin();
  program_ = program_of(path_.numbers() - origin_);
}

void Coordinates::roll_up(const PathPoint& path) {
  unrolled_.reset();
  refresh_origin();
  arrive_at(path);
}

void Coordinates::set_transform(const Transform& transform) {
  transform_ = transform;
  plain_ = transform_.identity() && origin_ == AxisVector{};
  program_ = program_of(path_.numbers() - origin_);
}

}  // namespace kerf::control
