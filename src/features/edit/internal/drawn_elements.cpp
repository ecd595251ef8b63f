#include "features/edit/internal/drawn_elements.hpp"

#include <cmath>
#include <limits>
#include <list>
#include <utility>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Edge;
using contour::Vec2;
using Step = Outline::Step;
using Steps = std::list<Step>;

// Asked for each gap and each element: the root is many times faster than a length without
// overflow.
double apart(Vec2 a, Vec2 b) { return std::sqrt(dot(a - b, a - b)); }

/// Between two elements, or before the first or behind the last one of an open contour.
struct Gap {
  Steps::iterator behind;  // what stands behind it; end(): nothing but, in a closed one, the first
  bool has_before = false;
  bool has_after = false;
  Vec2 before{};
  Vec2 after{};
  double width = 0;

  [[nodiscard]] bool is_one() const { return !(has_before && has_after) || width > kSamePoint_mm; }
  // How much of gaps more there is with the edge in it.
  [[nodiscard]] double cost(const Edge& edge) const {
    return (has_before ? apart(before, edge.from) : 0) + (has_after ? apart(edge.to, after) : 0) -
           width;
  }
};

class Places {
 public:
  Places(std::vector<Step> placed, bool is_closed)
      : steps_(placed.begin(), placed.end()), is_closed_(is_closed) {
    for (auto step = steps_.begin(); step != steps_.end(); ++step) note(gap_before(step));
    if (!steps_.empty()) note(gap_before(steps_.end()));
  }

  void place(const Step& drawn) {
    std::size_t best = gaps_.size();
    bool is_turned = false;
    double least = std::numeric_limits<double>::infinity();
    const Edge back = contour::reversed(drawn.edge);
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      for (const bool turned : {false, true}) {
        const double cost = gaps_[i].cost(turned ? back : drawn.edge);
        if (cost >= least) continue;
        least = cost;
        best = i;
        is_turned = turned;
      }
    }
    put({drawn.element, is_turned ? back : drawn.edge}, best);
  }

  [[nodiscard]] std::vector<Step> all() const { return {steps_.begin(), steps_.end()}; }

 private:
  void put(const Step& step, std::size_t gap) {
    const auto behind = gap < gaps_.size() ? gaps_[gap].behind : steps_.end();
    const auto here = steps_.insert(behind, step);
    if (gap < gaps_.size()) gaps_.erase(gaps_.begin() + static_cast<std::ptrdiff_t>(gap));
    note(gap_before(here));
    note(gap_before(std::next(here)));
  }

  // In a closed contour the gap before the first element is that behind the last one.
  void note(const Gap& gap) {
    if (is_closed_ && gap.behind == steps_.begin()) return;
    if (gap.is_one()) gaps_.push_back(gap);
  }

  Gap gap_before(Steps::iterator step) {
    Gap gap{.behind = step};
    gap.has_before = is_closed_ || step != steps_.begin();
    gap.has_after = is_closed_ || step != steps_.end();
    if (gap.has_before) gap.before = edge_before(step).to;
    if (gap.has_after) gap.after = edge_at(step).from;
    if (gap.has_before && gap.has_after) gap.width = apart(gap.before, gap.after);
    return gap;
  }

  const Edge& edge_before(Steps::iterator step) {
    return step == steps_.begin() ? steps_.back().edge : std::prev(step)->edge;
  }
  const Edge& edge_at(Steps::iterator step) {
    return step == steps_.end() ? steps_.front().edge : step->edge;
  }

  Steps steps_;
  bool is_closed_ = true;
  std::vector<Gap> gaps_;
};

}  // namespace

std::vector<Outline::Step> with_drawn(std::vector<Outline::Step> placed,
                                      const std::vector<Outline::Step>& drawn, bool is_closed) {
  if (drawn.empty()) return placed;
  Places places(std::move(placed), is_closed);
  for (const Outline::Step& step : drawn) places.place(step);
  return places.all();
}

}  // namespace kerf::features
