#include "job/internal/stock_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace kerf::job {
namespace {

using stock::Bounds;
using stock::Vec3;

constexpr double kLeastCell_mm = 0.02;
constexpr double kCellsAcrossTool = 40;
constexpr double kUsualDiameter_mm = 6;
constexpr double kAround_mm = 0.5;
constexpr double kInFront_mm = 1;

void take_in(Bounds& all, const Bounds& one) {
  all.low = {std::min(all.low.x, one.low.x), std::min(all.low.y, one.low.y),
             std::min(all.low.z, one.low.z)};
  all.high = {std::max(all.high.x, one.high.x), std::max(all.high.y, one.high.y),
              std::max(all.high.z, one.high.z)};
}

using Shape = base::Outcome<stock::Workpiece>;

base::Failure without_cuts(std::string_view example) {
  return {base::Failure::Kind::usage,
          fmt::format("--stock extents: the program has no move that cuts, so the stock needs its "
                      "measures: --stock {}",
                      example)};
}

// stock.md §2.1: half a millimetre round the largest diameter, one in front, the margin behind.
// Tools come to the face at feed from before it: the front is that of the face, where something is
// cut behind it.
Shape bar_around(const machine::StockAround& word, const SurveyedTools& tools,
                 std::vector<control::Assumption>& assumed) {
  if (!tools.extents()) return tl::unexpected(without_cuts("bar:D,Z0,Z1"));
  const Bounds& cut = *tools.extents();
  const double rho = std::max(std::fabs(cut.low.x), std::fabs(cut.high.x));
  const double front = cut.low.z < 0 ? std::min(cut.high.z, 0.0) : cut.high.z;
  const stock::CylinderShape bar{.from = cut.low.z - word.margin_mm,
                                 .to = front + kInFront_mm,
                                 .diameter = 2 * (rho + kAround_mm)};
  assumed.push_back({0, fmt::format("the stock is a bar of diameter {:.3f}, Z {:.3f} to {:.3f}",
                                    bar.diameter, bar.from, bar.to)});
  return stock::Workpiece(bar);
}

// stock.md §2.1: the bottom is a margin below the lowest tip, the top the zero of the stock where a
// move cuts below it.
Shape around(const machine::StockAround& word, const SurveyedTools& tools,
             std::vector<control::Assumption>& assumed) {
  if (!tools.extents()) return tl::unexpected(without_cuts("box:…"));
  const Bounds& cut = *tools.extents();
  const double m = word.margin_mm;
  const double bottom = cut.low.z - m;
  const double top = cut.low.z < 0 ? 0 : std::max(tools.highest_across().value_or(0), bottom + 1);
  const stock::BoxShape box{{cut.low.x - m, cut.low.y - m, bottom},
                            {cut.high.x + m, cut.high.y + m, top}};
  assumed.push_back(
      {0, fmt::format("the stock is a box around what is cut, X {:.3f} to {:.3f}, Y {:.3f} to "
                      "{:.3f}, Z {:.3f} to {:.3f}",
                      box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z)});
  return stock::Workpiece(box);
}

}  // namespace

SurveyedTools::SurveyedTools(const stock::Survey& survey, stock::ToolRack& rack, Vec3 origin) {
  for (const auto& [number, cut] : survey.tools()) {
    const stock::CuttingTool& tool = rack.tool(number);
    const double r = tool.diameter_mm() / 2;
    const Bounds widened{cut.low - origin - Vec3{r, r, 0}, cut.high - origin + Vec3{r, r, 0}};
    if (extents_) {
      take_in(*extents_, widened);
    } else {
      extents_ = widened;
    }
    if (cut.across)
      across_ = std::max(across_.value_or(*cut.across - origin.z), *cut.across - origin.z);
    if (r > 0) smallest_mm_ = std::min(smallest_mm_.value_or(2 * r), 2 * r);
    turned_ = turned_ || cut.turned;
    undercut_ = undercut_ || tool.body.profile.has_undercut();
  }
}

double SurveyedTools::cell_for(std::optional<double> smallest_mm) {
  const double least =
      std::max(smallest_mm.value_or(kUsualDiameter_mm) / kCellsAcrossTool, kLeastCell_mm);
  for (double decade = 0.01;; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step * decade >= least * (1 - 1e-12)) return step * decade;
    }
  }
}

Shape shape_of(const machine::StockWord& word, bool turns, const SurveyedTools& tools,
               std::vector<control::Assumption>& assumed) {
  if (const auto* const shape = std::get_if<stock::Workpiece>(&word)) return *shape;
  if (const auto* const margin = std::get_if<machine::StockAround>(&word))
    return turns ? bar_around(*margin, tools, assumed) : around(*margin, tools, assumed);
  if (const auto* const bar = std::get_if<machine::StockBar>(&word); turns && bar != nullptr) {
    return stock::Workpiece(stock::CylinderShape{.from = bar->z0,
                                                 .to = bar->z1,
                                                 .diameter = bar->diameter,
                                                 .inner_diameter = bar->inner_diameter});
  }
  return base::usage("--stock: this machine cannot have a stock of this kind");
}

}  // namespace kerf::job
