#include "output/path_plot.hpp"

#include <utility>

#include "output/internal/plot/path_recorder.hpp"
#include "output/internal/plot/png_writer.hpp"
#include "output/internal/plot/sheet.hpp"
#include "output/internal/plot/speed_recorder.hpp"
#include "output/internal/plot/svg_writer.hpp"

namespace kerf::output {
namespace {

constexpr double kPixelsPerUnit = 1.5;  // 2400 pixels wide

double x_scale_of(XMeasure x) { return x == XMeasure::diameter ? 0.5 : 1.0; }

}  // namespace

PathPlot::PathPlot(const control::AxisSetup& axes, std::string title, PlotColors colors, XMeasure x)
    : recorder_(std::make_unique<plot::PathRecorder>(axes, x_scale_of(x))),
      title_(std::move(title)) {
  if (colors == PlotColors::speeds)
    speeds_ = std::make_unique<plot::SpeedRecorder>(axes, x_scale_of(x));
}

PathPlot::~PathPlot() = default;

void PathPlot::take(const control::Motion& motion) { recorder_->take(motion); }
void PathPlot::start(const machine::AxisPoint& at) { speeds_->start(at.tip); }
void PathPlot::take(const machine::AxisPoint& point) { speeds_->take(point.tip); }

std::string PathPlot::svg() const {
  return plot::write_svg(plot::draw_sheet(*recorder_, speeds_.get(), title_));
}

std::string PathPlot::png() const {
  return plot::write_png(plot::draw_sheet(*recorder_, speeds_.get(), title_), kPixelsPerUnit);
}

}  // namespace kerf::output
