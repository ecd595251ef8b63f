#include "process/raster.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "process/internal/dots.hpp"
#include "process/internal/grey_rows.hpp"

namespace kerf::process {
namespace {

constexpr double kUsualInterval_mm = 0.1;
constexpr double kMostGridPixels = 400e6;

std::uint32_t cells_along(double length_mm, double cell_mm) {
  return static_cast<std::uint32_t>(
      std::max(std::int64_t{1}, base::round_away(length_mm / cell_mm)));
}

GreyRows::Grid grid_of(const GreyImage& image, Vec2 size_mm, double pixel_mm, double interval_mm) {
  return {cells_along(size_mm.u, pixel_mm), cells_along(size_mm.v, interval_mm),
          pixel_mm * image.width / size_mm.u, interval_mm * image.height / size_mm.v};
}

}  // namespace

tl::expected<Raster, base::Diagnostic> Raster::make(const GreyImage& image,
                                                    const Operation& operation,
                                                    const Settled& settled, Vec2 size_mm) {
  const double interval_mm = operation.interval.value_or(kUsualInterval_mm);
  const double pixel_mm = operation.pixel.value_or(interval_mm);
  const double pixels =
      std::max(1.0, size_mm.u / pixel_mm) * std::max(1.0, size_mm.v / interval_mm);
  if (!(pixels <= kMostGridPixels)) {
    return tl::unexpected(
        make_error(base::Code::job_value, operation.place,
                   "operation " + operation.name + ": a picture of " +
                       base::rounded_text(size_mm.u, 3) + " x " + base::rounded_text(size_mm.v, 3) +
                       " mm would have more than 400 million "
                       "pixels of " +
                       base::number_text(pixel_mm) + " x " + base::number_text(interval_mm) + " mm",
                   "say a larger interval, or a smaller picture"));
  }
  return Raster(image, operation, settled, size_mm, pixel_mm, interval_mm);
}

Raster::Raster(const GreyImage& image, const Operation& operation, const Settled& settled,
               Vec2 size_mm, double pixel_mm, double interval_mm)
    : columns_(cells_along(size_mm.u, pixel_mm)),
      rows_(cells_along(size_mm.v, interval_mm)),
      pixel_mm_(pixel_mm),
      interval_mm_(interval_mm),
      height_mm_(size_mm.v),
      is_bidirectional_(operation.bidirectional),
      shift_mm_(linear_between(operation.scan_offset, settled.feed)),
      greys_(std::make_unique<GreyRows>(image, operation,
                                        grid_of(image, size_mm, pixel_mm, interval_mm))),
      dots_(dots_of(operation, settled, columns_)),
      powers_(columns_) {}

Raster::~Raster() = default;
Raster::Raster(Raster&&) noexcept = default;
Raster& Raster::operator=(Raster&&) noexcept = default;

bool Raster::next(ScanLine& line) {
  while (row_ < rows_) {
    dots_->make(greys_->next(), powers_);
    line.origin = {0, height_mm_ - (row_ + 0.5) * interval_mm_};
    line.along = {1, 0};
    ++row_;
    find_runs(line);
    if (line.runs.empty()) continue;
    if (goes_back_) turn_back(line);
    goes_back_ = is_bidirectional_ && !goes_back_;
    return true;
  }
  return false;
}

/// Pixels side by side of the same power.
void Raster::find_runs(ScanLine& line) {
  line.runs.clear();
  for (std::uint32_t x = 0; x < columns_;) {
    const double power = powers_[x];
    std::uint32_t end = x + 1;
    while (end < columns_ && powers_[end] == power) ++end;
    if (power > 0) {
      line.runs.push_back({x * pixel_mm_, end * pixel_mm_, power});
      burnt_ += end - x;
    }
    x = end;
  }
  runs_ += line.runs.size();
}

void Raster::turn_back(ScanLine& line) const {
  const double width_mm = columns_ * pixel_mm_;
  line.origin.u = width_mm + shift_mm_;
  line.along = {-1, 0};
  std::reverse(line.runs.begin(), line.runs.end());
  for (Run& run : line.runs) run = {width_mm - run.to, width_mm - run.from, run.power};
}

double linear_between(const std::vector<std::pair<double, double>>& pairs, double at) {
  if (pairs.empty()) return 0;
  const auto next = std::lower_bound(pairs.begin(), pairs.end(), at,
                                     [](const auto& pair, double x) { return pair.first < x; });
  if (next == pairs.begin()) return next->second;
  if (next == pairs.end()) return pairs.back().second;
  const auto last = next - 1;
  const double share = (at - last->first) / (next->first - last->first);
  return last->second + share * (next->second - last->second);
}

}  // namespace kerf::process
