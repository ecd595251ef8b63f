#include "features/literal/loops.hpp"

#include "features/path/point_index.hpp"
#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;

/// Walks along rows and keeps the open chain: its points, and the rows between them.
class LoopFinder {
 public:
  explicit LoopFinder(const Recording& recording) : recording_(recording) {}

  void follow(std::uint32_t row) {
    const Vec2 from = recording_.flat_from(row);
    const Vec2 to = recording_.flat_to(row);
    const bool goes_on = !ends_.empty() && geometry::length(from - end_) <= kSamePoint_mm;
    if (!goes_on) begin_at(from);
    rows_.push_back(row);
    const auto earlier = points_.near(to);
    if (earlier) {
      close(*earlier, to);
    } else {
      ends_.push_back(to);
      points_.add(to, static_cast<std::uint32_t>(ends_.size() - 1));
      end_ = to;
    }
  }

  LoopsOfRows done() {
    link(rows_.size());
    return std::move(found_);
  }

 private:
  void begin_at(Vec2 from) {
    link(rows_.size());
    rows_.clear();
    ends_.assign(1, from);
    points_.forget();
    points_.add(from, 0);
    end_ = from;
  }

  void link(std::size_t count) {
    found_.links.insert(found_.links.end(), rows_.begin(),
                        rows_.begin() + static_cast<std::ptrdiff_t>(count));
  }

  // The rows behind point `first` come round to it.
  void close(std::uint32_t first, Vec2 at) {
    link(first);
    Loop loop{.rows = {rows_[first], rows_.back()}};
    const Contour contour = recording_.contour_of(loop.rows);
    loop.perimeter = contour::length(contour);
    loop.area = contour::area(contour);
    found_.loops.push_back(loop);
    rows_.clear();
    begin_at(at);
  }

  const Recording& recording_;
  std::vector<std::uint32_t> rows_;  // row i leads from point i to point i + 1
  std::vector<Vec2> ends_;
  PointIndex points_;
  Vec2 end_;
  LoopsOfRows found_;
};

}  // namespace

LoopsOfRows loops_of(const Recording& recording, const std::vector<std::uint32_t>& rows) {
  LoopFinder finder(recording);
  for (const std::uint32_t row : rows) finder.follow(row);
  return finder.done();
}

}  // namespace kerf::features
