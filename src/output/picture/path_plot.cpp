#include "output/picture/path_plot.hpp"

#include <utility>

#include "output/picture/drawing/png_writer.hpp"
#include "output/picture/drawing/svg_writer.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/internal/cut_recorder.hpp"
#include "output/picture/internal/energy_of_cut.hpp"
#include "output/picture/internal/path_recorder.hpp"
#include "output/picture/internal/sheet.hpp"

namespace kerf::output {
namespace {

constexpr double kPixelsPerUnit = 1.5;  // 2400 pixels wide

double x_scale_of(XMeasure x) { return x == XMeasure::diameter ? 0.5 : 1.0; }

}  // namespace

PathPlot::PathPlot(const motion::AxisSetup& axes, std::string title, PlotColors colors, XMeasure x)
    : recorder_(std::make_unique<plot::PathRecorder>(axes, x_scale_of(x))),
      title_(std::move(title)) {
  if (colors == PlotColors::speeds)
    cuts_ = std::make_unique<plot::CutRecorder>(axes, x_scale_of(x),
                                                std::make_unique<plot::SpeedOfCut>());
}

PathPlot::PathPlot(const motion::AxisSetup& axes, std::string title,
                   const machine::LaserSettings& laser)
    : PathPlot(axes, std::move(title)) {
  auto energy = std::make_unique<plot::EnergyOfCut>(laser);
  energy_ = energy.get();
  cuts_ = std::make_unique<plot::CutRecorder>(axes, 1, std::move(energy));
}

PathPlot::~PathPlot() = default;

void PathPlot::take(const motion::Motion& motion) { recorder_->take(motion); }
void PathPlot::travel_through(const base::TipPoint& place) { recorder_->travel_through(place); }
void PathPlot::start(const motion::AxisPoint& at) { cuts_->start(at.tip); }
void PathPlot::take(const motion::AxisPoint& point) { cuts_->take(point.tip, point.power_percent); }

std::string PathPlot::remark() const {
  if (energy_ == nullptr || !(energy_->most() > 0)) return {};
  return "  energy of the cuts: median " + plot::significant(energy_->median()) + " J/mm, most " +
         plot::significant(energy_->most()) + " J/mm at line " +
         std::to_string(energy_->line_of_most()) + "\n";
}

std::string PathPlot::svg() const {
  return plot::write_svg(plot::draw_sheet(*recorder_, cuts_.get(), title_));
}

std::string PathPlot::png() const {
  return plot::write_png(plot::draw_sheet(*recorder_, cuts_.get(), title_), kPixelsPerUnit);
}

}  // namespace kerf::output
