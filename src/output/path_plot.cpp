#include "output/path_plot.hpp"

#include <utility>

#include "output/internal/plot/path_recorder.hpp"
#include "output/internal/plot/png_writer.hpp"
#include "output/internal/plot/sheet.hpp"
#include "output/internal/plot/svg_writer.hpp"

namespace kerf::output {
namespace {

constexpr double kPixelsPerUnit = 1.5;  // 2400 pixels wide

}  // namespace

PathPlot::PathPlot(const control::AxisSetup& axes, std::string title, XMeasure x)
    : recorder_(std::make_unique<plot::PathRecorder>(axes, x == XMeasure::diameter ? 0.5 : 1.0)),
      title_(std::move(title)) {}

PathPlot::~PathPlot() = default;

void PathPlot::take(const control::Motion& motion) { recorder_->take(motion); }

std::string PathPlot::svg() const { return plot::write_svg(plot::draw_sheet(*recorder_, title_)); }

std::string PathPlot::png() const {
  return plot::write_png(plot::draw_sheet(*recorder_, title_), kPixelsPerUnit);
}

}  // namespace kerf::output
