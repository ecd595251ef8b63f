#include "output/picture/path_plot.hpp"

#include <utility>

#include "base/decimal.hpp"
#include "output/picture/drawing/png_writer.hpp"
#include "output/picture/drawing/svg_writer.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/internal/cut_recorder.hpp"
#include "output/picture/internal/energy_of_cut.hpp"
#include "output/picture/internal/path_recorder.hpp"
#include "output/picture/internal/sheet.hpp"
#include "output/picture/internal/turning_recorder.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

constexpr double kPixelsPerUnit = 1.5;  // 2400 pixels wide

}  // namespace

PathPlot::PathPlot(const motion::AxisSetup& axes, std::string title, PlotColors colors,
                   const ToolTable& tools)
    : recorder_(std::make_unique<plot::PathRecorder>(axes)), title_(std::move(title)) {
  if (axes.turns()) turning_ = std::make_unique<plot::TurningRecorder>(axes, tools);
  if (colors == PlotColors::speeds)
    cuts_ = std::make_unique<plot::CutRecorder>(axes, std::make_unique<plot::SpeedOfCut>());
}

PathPlot::PathPlot(const motion::AxisSetup& axes, std::string title,
                   const machine::LaserSettings& laser)
    : PathPlot(axes, std::move(title)) {
  auto energy = std::make_unique<plot::EnergyOfCut>(laser);
  energy_ = energy.get();
  cuts_ = std::make_unique<plot::CutRecorder>(axes, std::move(energy));
}

PathPlot::~PathPlot() = default;

void PathPlot::take(const motion::Motion& motion) {
  const plot::Point3 from = recorder_->position();
  recorder_->take(motion);
  if (turning_) turning_->take(motion, *recorder_, from);
}

plot::DisplayList PathPlot::sheet() const {
  return plot::draw_sheet(*recorder_, turning_.get(), cuts_.get(), title_);
}

void PathPlot::travel_through(const base::TipPoint& place) { recorder_->travel_through(place); }
void PathPlot::start(const motion::AxisPoint& at) { cuts_->start(at.tip); }
void PathPlot::take(const motion::AxisPoint& point) { cuts_->take(point.tip, point.power_percent); }

std::string PathPlot::remark() const {
  if (energy_ == nullptr || !(energy_->most() > 0)) return {};
  return "  energy of the cuts: median " + plot::significant(energy_->median()) + " J/mm, most " +
         plot::significant(energy_->most()) + " J/mm at line " +
         std::to_string(energy_->line_of_most()) +
         "\n  energy of the beam: " + plot::significant(energy_->total_j()) + " J\n";
}

std::string PathPlot::energy_json() const {
  if (energy_ == nullptr) return {};
  JsonObject object;
  object.number("total_j", base::tidy(energy_->total_j()))
      .number("median_j_mm", base::tidy(energy_->median()))
      .number("most_j_mm", base::tidy(energy_->most()))
      .number("line", energy_->line_of_most());
  return object.done();
}

std::string PathPlot::svg() const { return plot::write_svg(sheet()); }

std::string PathPlot::png() const { return plot::write_png(sheet(), kPixelsPerUnit); }

}  // namespace kerf::output
