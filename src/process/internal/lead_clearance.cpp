#include "process/internal/lead_clearance.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/edge.hpp"
#include "process/along.hpp"

namespace kerf::process {
namespace {

using contour::Box;
using contour::Edge;

constexpr double kTouch_mm = 1e-9;

/// All edges of all passes, by place.
class Walls {
 public:
  explicit Walls(const std::vector<Pass>& passes) : tree_(boxes(passes)) {}

  /// Whether the lead, which has its near end on an edge of `own`, keeps away from everything else.
  [[nodiscard]] bool are_clear_of(const Edge& lead, std::size_t own, double clearance) const {
    bool is_clear = true;
    tree_.search(extents(lead).grown(clearance), [&](std::size_t item) {
      // Where it leaves its own way it is near to that, and further on it must not come back.
      const bool is_own = owners_[item] == own;
      for (double from_end = is_own ? 0.25 : 0; from_end <= 1; from_end += 0.125) {
        const double least = is_own && from_end < 0.6 ? kTouch_mm : clearance - kTouch_mm;
        if (distance(edges_[item], point_at(lead, 1 - from_end)) < least) is_clear = false;
      }
    });
    return is_clear;
  }

 private:
  std::vector<Box> boxes(const std::vector<Pass>& passes) {
    std::vector<Box> found;
    for (std::size_t i = 0; i < passes.size(); ++i) {
      const auto* along = std::get_if<Along>(&passes[i].what);
      if (along == nullptr) continue;
      for (std::size_t k = 0; k < edge_count(along->path); ++k) {
        edges_.push_back(edge_of(along->path, k));
        owners_.push_back(i);
        found.push_back(extents(edges_.back()));
      }
    }
    return found;
  }

  std::vector<Edge> edges_;
  std::vector<std::size_t> owners_;
  contour::BoxTree tree_;
};

double longest_clear(const Walls& walls, const Along& along, std::size_t entry,
                     const AlongRules& rules, std::size_t own, bool leads_in) {
  constexpr double kLeast = 0.125;
  Along trial = along;
  for (double share = 1; share >= kLeast; share *= 0.5) {
    (leads_in ? trial.leads[entry].in : trial.leads[entry].out) = share;
    const Way way = leads_in ? lead_in_of(trial, entry, rules) : lead_out_of(trial, entry, rules);
    if (way.legs.empty()) return 1;
    Edge lead{way.begin, way.legs.back().to, way.legs.back().bulge};
    if (!leads_in) lead = reversed(lead);
    if (walls.are_clear_of(lead, own, 0.5 * rules.kerf)) return share;
  }
  return 0;
}

bool shorten(const Walls& walls, Along& along, const AlongRules& rules, std::size_t own) {
  along.leads.assign(along.starts.size(), {});
  bool all = !along.starts.empty();
  for (std::size_t entry = 0; entry < along.starts.size(); ++entry) {
    LeadShare share;
    share.in = longest_clear(walls, along, entry, rules, own, true);
    share.out = longest_clear(walls, along, entry, rules, own, false);
    along.leads[entry] = share;
    all = all && (share.in < 1 || share.out < 1);
  }
  return all;
}

/// Starts with whole leads, where there are any.
void keep_whole(Along& along) {
  std::vector<double> starts;
  for (std::size_t i = 0; i < along.starts.size(); ++i)
    if (along.leads[i].in >= 1 && along.leads[i].out >= 1) starts.push_back(along.starts[i]);
  if (starts.empty()) return;
  along.starts = std::move(starts);
  along.leads.clear();
}

}  // namespace

void shorten_leads(std::vector<Pass>& passes, const AlongRules& rules,
                   std::vector<Remark>& remarks) {
  const bool has_leads =
      rules.lead_in.kind != Lead::Kind::none || rules.lead_out.kind != Lead::Kind::none;
  if (!has_leads) return;
  const Walls walls(passes);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    auto* along = std::get_if<Along>(&passes[i].what);
    if (along == nullptr || !along->path.is_closed) continue;
    if (shorten(walls, *along, rules, i))
      remarks.push_back({base::Code::lead_shortened, false, passes[i].entity, ""});
    else
      keep_whole(*along);
  }
}

}  // namespace kerf::process
