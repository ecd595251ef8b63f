#include "stock/replay/sheet_recording.hpp"

#include <algorithm>
#include <cassert>
#include <mutex>

#include "stock/replay/sheet_tiles.hpp"

namespace kerf::stock::replay {
namespace {

Record::Settings half_of(Record::Settings settings) {
  settings.memory_bytes /= 2;
  return settings;
}

}  // namespace

SheetRecording::SheetRecording(sheet::Sheet& sheet, const Record::Settings& settings)
    : coverage_(coverage_tiles(sheet)),
      energy_(energy_tiles(sheet)),
      cuts_(*coverage_, half_of(settings)),
      burns_(*energy_, half_of(settings)) {}

void SheetRecording::cut(std::span<const sheet::Trace> traces,
                         std::span<const std::uint32_t> motions) {
  assert(traces.size() == motions.size());
  if (cuts_.is_full()) return;
  {
    const std::unique_lock lock(mutex_);
    for (std::size_t i = 0; i < traces.size(); ++i) traces_.push_back({traces[i], motions[i]});
  }
  cuts_.done(traces_.size(), traces_.size() * sizeof(Cut));
}

void SheetRecording::tell(std::uint32_t motion, double start_s, double end_s) {
  while (told_ < traces_.size() && traces_[told_].motion <= motion) ++told_;
  cuts_.tell(told_, start_s, end_s);
}

void SheetRecording::burn(std::span<const sheet::Burn> burns, std::span<const double> until_s) {
  assert(burns.size() == until_s.size());
  if (burns_.is_full()) return;
  std::size_t steps = burnt_.size();
  {
    const std::unique_lock lock(mutex_);
    burnt_.insert(burnt_.end(), burns.begin(), burns.end());
  }
  burns_.done(burnt_.size(), burnt_.size() * sizeof(sheet::Burn));
  for (const double time_s : until_s) {
    burns_.tell(++steps, burnt_until_s_, time_s);
    burnt_until_s_ = time_s;
  }
}

void SheetRecording::finish(double time_s) {
  cuts_.finish(time_s);
  burns_.finish(time_s);
}

double SheetRecording::reached_s() const { return std::min(cuts_.reached_s(), burns_.reached_s()); }

std::vector<sheet::Trace> SheetRecording::traces(std::size_t from, std::size_t to) const {
  const std::shared_lock lock(mutex_);
  std::vector<sheet::Trace> some;
  for (std::size_t i = from; i < to; ++i) some.push_back(traces_[i].trace);
  return some;
}

std::vector<sheet::Burn> SheetRecording::burnt(std::size_t from, std::size_t to) const {
  const std::shared_lock lock(mutex_);
  return {burnt_.begin() + static_cast<std::ptrdiff_t>(from),
          burnt_.begin() + static_cast<std::ptrdiff_t>(to)};
}

}  // namespace kerf::stock::replay
