#pragma once

#include <optional>
#include <string>
#include <vector>

#include "face/server/protocol/json.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/variable_listing.hpp"
#include "machine/panel/snapshot.hpp"

namespace kerf::server {

/// The keys of a `state` event that the machine itself says (docs/panel-protocol.md).
[[nodiscard]] Json state_json(const machine::Snapshot& snapshot,
                              const machine::MachineDefinition& definition);

/// `definition` of the answer to `watch`: axes, joints, linkage, period.
[[nodiscard]] Json definition_json(const machine::MachineDefinition& definition);

/// Variables of a listing, and its scopes.
[[nodiscard]] Json variables_json(const machine::VariableListing& listing);

[[nodiscard]] Json breakpoint_json(const machine::Breakpoint& breakpoint);

}  // namespace kerf::server
