#include "planner/internal/motion_ends.hpp"

#include <algorithm>
#include <span>

namespace kerf::planner {
namespace {

/// Nearer to the end of a phase a place is its end: where the axes come to rest, rounding of the
/// way would be much of the time.
constexpr double kSameWay = 1e-9;

/// When a phase has come as far as `way`, by halving: its way never falls with time.
double time_of(const Phase& phase, double way) {
  if (phase.acceleration == 0 && phase.jerk == 0)
    return phase.velocity > 0 ? std::clamp(way / phase.velocity, 0.0, phase.duration_s) : 0;
  double low = 0;
  double high = phase.duration_s;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (phase.way(middle) < way ? low : high) = middle;
  }
  return high;
}

}  // namespace

/// Goes along the phases of a section: places are asked in the order of the path.
class PhaseWalk {
 public:
  PhaseWalk(const Section& section, const Profile& profile, double begin_s)
      : phases_(section.dwell_s > 0 ? std::span<const Phase>() : profile.phases()),
        time_s_(begin_s + section.dwell_s) {}

  /// When the section has come as far as `way`.
  [[nodiscard]] double at(double way) {
    for (; !phases_.empty(); phases_ = phases_.subspan(1)) {
      const Phase& phase = phases_.front();
      const double length = phase.way(phase.duration_s);
      if (way < way_ + length - kSameWay)
        return time_s_ + time_of(phase, std::max(0.0, way - way_));
      way_ += length;
      time_s_ += phase.duration_s;
    }
    return time_s_;
  }

 private:
  std::span<const Phase> phases_;  // that are not over
  double time_s_;                  // at their begin
  double way_ = 0;
};

void MotionEnds::tell(const motion::Mark& mark, double time_s) {
  last_s_ = std::max(last_s_, time_s);
  sink_->motion_ends(mark.motion, last_s_);
}

void MotionEnds::tell(const WayAhead& ahead, const Section& section, double offset,
                      const Profile& profile, double begin_s) {
  PhaseWalk walk(section, profile, begin_s);
  double cell_way = -offset;
  next_ = std::max(next_, ahead.path.marks.begin());
  for (std::uint64_t n = 0; n < section.cells; ++n) {
    const Cell& cell = ahead.cells[ahead.cells.begin() + n];
    tell_cell(ahead, cell, cell.end, cell_way, walk);
    cell_way += cell.length();
  }
  if (section.tail == 0) return;
  const Cell& cell = ahead.cells[ahead.cells.begin() + section.cells];
  tell_cell(ahead, cell, cell.begin + section.tail, cell_way, walk);
}

// What waits for the spindle belongs to the motion behind it, which is not over then.
void MotionEnds::tell_cell(const WayAhead& ahead, const Cell& cell, double last, double cell_way,
                           PhaseWalk& walk) {
  const Ring<PathMark>& marks = ahead.path.marks;
  for (; next_ < marks.end(); ++next_) {
    const PathMark& mark = marks[next_];
    if (mark.piece > cell.piece || (mark.piece == cell.piece && mark.way > last)) return;
    const bool is_before = mark.piece < cell.piece;
    const bool waits = mark.mark.kind == motion::MoveKind::dwell && !is_before &&
                       ahead.path.pieces[cell.piece].waits_for_spindle();
    if (waits) continue;
    tell(mark.mark, walk.at(is_before ? cell_way : cell_way + (mark.way - cell.begin)));
  }
}

}  // namespace kerf::planner
