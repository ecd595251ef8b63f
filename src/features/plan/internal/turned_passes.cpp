#include "features/plan/internal/turned_passes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;

constexpr double kMostLeft_mm = 5;       // between a pass and where it is fed from
constexpr double kMostForFinish_mm = 1;  // more is left because nobody cuts it before
constexpr int kMostNew = 1000;           // passes that come in

/// A pass along the axis at a radius, or across it at a place.
struct Pass {
  Span visit{};
  std::uint32_t row = 0;  ///< that cuts the most of it
  bool along_z = true;
  double level = 0;
};

double depth_of(Vec2 point, bool along_z) { return along_z ? point.v : point.u; }

/// Makes passes for a contour. Depths are counted so that they grow where more is cut: towards the
/// axis outside, away from it inside, to the back across.
class PassMaker {
 public:
  PassMaker(const Recording& recording, const TurnedPart& part, const Contour& now,
            const std::vector<Span>& visits)
      : recording_(recording), part_(part), now_(now), shift_(part.contour, now) {
    for (const Span& visit : visits) passes_.push_back(pass_of(visit));
  }

  [[nodiscard]] std::vector<Stretch> make() {
    std::vector<Stretch> made;
    if (passes_.empty()) return made;
    const bool is_one_way = std::all_of(passes_.begin(), passes_.end(), [&](const Pass& pass) {
      return pass.along_z == passes_.front().along_z;
    });
    const double floor = floor_of(now_) - left();
    const double cuts_in = left() <= kMostForFinish_mm ? floor : floor_of(now_);
    for (const Pass& pass : passes_) {
      Stretch stretch{.rows = pass.visit};
      const bool goes = is_one_way && is_deeper_ && deep(pass.level) > cuts_in + kSamePoint_mm;
      if (!goes) stretch.becomes = at_level(pass, pass.level);
      made.push_back(std::move(stretch));
    }
    if (is_one_way && is_deeper_) go_deeper(floor, made.back());
    return made;
  }
  /// Only a contour whose deepest place has moved needs other levels.
  void look() { is_deeper_ = std::fabs(floor_of(now_) - floor_of(part_.contour)) > kSamePoint_mm; }

 private:
  [[nodiscard]] Pass pass_of(Span visit) const {
    Pass pass{.visit = visit, .row = visit.first};
    double most = 0;
    for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
      if (!recording_.moves[row].cuts() || recording_.length_of(row) <= most) continue;
      most = recording_.length_of(row);
      pass.row = row;
    }
    const Vec2 way = recording_.flat_to(pass.row) - recording_.flat_from(pass.row);
    pass.along_z = std::fabs(way.u) >= std::fabs(way.v);
    pass.level = depth_of(recording_.flat_to(pass.row), pass.along_z);
    return pass;
  }

  [[nodiscard]] double deep(double level) const {
    return passes_.front().along_z && !part_.outer ? level : -level;
  }
  [[nodiscard]] double floor_of(const Contour& contour) const {
    double floor = -1e300;
    for (const auto& vertex : contour.vertices)
      floor = std::max(floor, deep(depth_of(vertex.point, passes_.front().along_z)));
    return floor;
  }
  /// What the deepest pass leaves.
  [[nodiscard]] double left() const {
    std::optional<double> least;
    for (const Pass& pass : passes_) {
      const double over = floor_of(part_.contour) - deep(pass.level);
      if (over > -kSamePoint_mm) least = std::min(least.value_or(over), std::max(over, 0.0));
    }
    return least.value_or(0);
  }
  [[nodiscard]] double step() const {
    std::vector<double> steps;
    for (std::size_t i = 1; i < passes_.size(); ++i)
      steps.push_back(deep(passes_[i].level) - deep(passes_[i - 1].level));
    if (steps.empty()) return kMostLeft_mm;
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    return steps[steps.size() / 2];
  }

  /// The rows of a pass at another level, from it to where the contour is.
  [[nodiscard]] std::vector<PlannedRow> at_level(const Pass& pass, double level) const {
    std::vector<PlannedRow> rows;
    const double by = level - pass.level;
    Vec2 end = recording_.flat_to(pass.row);
    std::optional<double> farther = shift_.farther(end, pass.along_z);
    (pass.along_z ? end.v : end.u) += by;
    if (by != 0) farther = far_at(pass, end);
    for (std::uint32_t row = pass.visit.first; row <= pass.visit.last; ++row) {
      PlannedRow planned = as_it_is(recording_, row);
      if (is_beside(pass, row)) (pass.along_z ? planned.to.x : planned.to.z) += by;
      if (farther && row >= pass.row && recording_.moves[row].cuts())
        (pass.along_z ? planned.to.z : planned.to.x) += *farther;
      rows.push_back(planned);
    }
    return rows;
  }
  // As far before the new contour as the pass is before the old one.
  [[nodiscard]] std::optional<double> far_at(const Pass& pass, Vec2 end) const {
    const CornerShift there(now_, now_);
    Vec2 old_end = recording_.flat_to(pass.row);
    const auto old_place = CornerShift(part_.contour, part_.contour).place(old_end, pass.along_z);
    const auto new_place = there.place(end, pass.along_z);
    if (!old_place || !new_place) return std::nullopt;
    return *new_place - *old_place;
  }
  // Rows of the visit up to its end keep their distance from the level.
  [[nodiscard]] bool is_beside(const Pass& pass, std::uint32_t row) const {
    const Vec2 off = recording_.flat_to(row) - recording_.flat_to(pass.row);
    return std::fabs(depth_of(off, pass.along_z)) <= kMostLeft_mm;
  }

  void go_deeper(double floor, Stretch& last) const {
    const Pass& pattern = passes_.back();
    const double depth_of_cut = step();
    if (depth_of_cut <= kSamePoint_mm) return;
    double at = deep(pattern.level);
    for (int i = 0; i < kMostNew && at < floor - kSamePoint_mm; ++i) {
      at = std::min(at + depth_of_cut, floor);
      const double level = passes_.front().along_z && !part_.outer ? at : -at;
      for (PlannedRow row : at_level(pattern, level)) {
        row.was.reset();
        last.becomes.push_back(row);
      }
    }
  }

  const Recording& recording_;
  const TurnedPart& part_;
  const Contour& now_;
  CornerShift shift_;
  std::vector<Pass> passes_{};
  bool is_deeper_ = false;
};

}  // namespace

std::vector<Stretch> passes_for(const Recording& recording, const TurnedPart& part,
                                const Contour& now, const std::vector<Span>& visits) {
  PassMaker maker(recording, part, now, visits);
  if (!visits.empty()) maker.look();
  return maker.make();
}

}  // namespace kerf::features
