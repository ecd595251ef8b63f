#include "stock/replay/sheet_player.hpp"

#include "stock/replay/sheet_tiles.hpp"

namespace kerf::stock::replay {
namespace {

using sheet::Burn;
using sheet::Trace;

/// Of traces that are one motion only this share of their way is left.
void shorten(std::vector<Trace>& traces, double share) {
  double way = 0;
  for (const Trace& trace : traces) way += length(trace);
  double rest = way * share;
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const double one = length(traces[i]);
    if (rest < one) {
      traces[i] = part(traces[i], rest / one);
      traces.resize(i + 1);
      return;
    }
    rest -= one;
  }
}

}  // namespace

SheetPlayer::SheetPlayer(std::unique_ptr<sheet::Sheet> sheet, const SheetRecording& recording)
    : sheet_(std::move(sheet)),
      recording_(recording),
      coverage_(coverage_tiles(*sheet_)),
      energy_(energy_tiles(*sheet_)),
      cuts_(*coverage_, [this](std::size_t a, std::size_t b, double share) { cut(a, b, share); },
            {}),
      burns_(*energy_, [this](std::size_t a, std::size_t b, double share) { burn(a, b, share); },
             {}) {}

bool SheetPlayer::go_to(double time_s, const std::stop_token& unwanted) {
  return cuts_.go_to(recording_.cuts(), recording_.cuts().at(time_s), unwanted) &&
         burns_.go_to(recording_.burns(), recording_.burns().at(time_s), unwanted);
}

void SheetPlayer::cut(std::size_t from, std::size_t to, double share) {
  std::vector<Trace> traces = recording_.traces(from, to);
  if (share < 1) shorten(traces, share);
  sheet_->cut(traces);
}

void SheetPlayer::burn(std::size_t from, std::size_t to, double share) {
  std::vector<Burn> burns = recording_.burnt(from, to);
  for (Burn& each : burns) {
    if (!(share < 1)) break;
    each.to = each.from + share * (each.to - each.from);
    each.energy_j *= share;
  }
  sheet_->burn(burns);
}

}  // namespace kerf::stock::replay
