#pragma once

#include <vector>

#include "process/passes.hpp"

namespace kerf::process {

/// Leads that would come nearer than half a kerf to the way of another pass get shorter by halves;
/// those that do at an eighth are left out. Told as LEAD_SHORTENED, of a pass only where all of its
/// starts are so.
void shorten_leads(std::vector<Pass>& passes, const AlongRules& rules,
                   std::vector<Remark>& remarks);

}  // namespace kerf::process
