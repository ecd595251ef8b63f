#include "stock/replay/sweep_log.hpp"

namespace kerf::stock::replay {
namespace {

constexpr std::uint32_t kFormShift = 30;

}  // namespace

void SweepLog::add(const Sweep& sweep) {
  const Like like{sweep.axis, sweep.lead_mm, sweep.start_deg, sweep.body, sweep.kind};
  if (likes_.empty() || !(likes_.back() == like)) likes_.push_back(like);
  const std::uint32_t place = place_of(sweep.way);
  records_.push_back({sweep.motion, static_cast<std::uint32_t>(likes_.size() - 1), place});
}

std::uint32_t SweepLog::place_of(const Way& way) {
  const auto placed = [](Form form, std::size_t number) {
    return static_cast<std::uint32_t>(form) << kFormShift | static_cast<std::uint32_t>(number);
  };
  if (const auto* const straight = std::get_if<StraightWay>(&way)) {
    if (points_.empty() || !(points_.back() == straight->from)) points_.push_back(straight->from);
    points_.push_back(straight->to);
    return placed(Form::straight, points_.size() - 2);
  }
  if (const auto* const arc = std::get_if<ArcWay>(&way)) {
    arcs_.push_back(*arc);
    return placed(Form::arc, arcs_.size() - 1);
  }
  turnings_.push_back(std::get<TurningWay>(way));
  return placed(Form::turning, turnings_.size() - 1);
}

Sweep SweepLog::operator[](std::size_t i) const {
  const Record& record = records_[i];
  const Like& like = likes_[record.like];
  const std::uint32_t number = record.place & ((1U << kFormShift) - 1);
  Sweep sweep{.axis = like.axis,
              .body = like.body,
              .kind = like.kind,
              .motion = record.motion,
              .lead_mm = like.lead_mm,
              .start_deg = like.start_deg};
  switch (static_cast<Form>(record.place >> kFormShift)) {
    case Form::straight: sweep.way = StraightWay{points_[number], points_[number + 1]}; break;
    case Form::arc: sweep.way = arcs_[number]; break;
    case Form::turning: sweep.way = turnings_[number]; break;
  }
  return sweep;
}

std::size_t SweepLog::bytes() const {
  const auto held = [](const auto& list) { return list.size() * sizeof list[0]; };
  return held(records_) + held(likes_) + held(points_) + held(arcs_) + held(turnings_);
}

}  // namespace kerf::stock::replay
