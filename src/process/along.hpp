#pragma once

#include "process/order.hpp"
#include "process/pass.hpp"

namespace kerf::process {

/// How many ways there are to make it.
[[nodiscard]] std::size_t entry_count(const Along& along);
/// The way by one of them: lead-in, once along with tabs, ramps and weave, overcut, lead-out.
[[nodiscard]] Way way_of(const Along& along, std::size_t entry, const AlongRules& rules);
/// Where it begins and ends, without all between.
[[nodiscard]] Entry entry_of(const Along& along, std::size_t entry, const AlongRules& rules);

/// Where a closed contour may be begun: its vertices, of many some; with leads the middles of edges
/// that are twice as long, where there are any.
[[nodiscard]] std::vector<double> starts_of(const contour::Contour& path, StartAt start,
                                            const AlongRules& rules);

/// The lead alone, in the direction of travel: the last leg of one that leads in ends on the path.
[[nodiscard]] Way lead_in_of(const Along& along, std::size_t entry, const AlongRules& rules);
[[nodiscard]] Way lead_out_of(const Along& along, std::size_t entry, const AlongRules& rules);

}  // namespace kerf::process
