#pragma once

#include <map>
#include <string_view>

#include "face/server/hub/hub.hpp"
#include "machine/panel/operation_table.hpp"

namespace kerf::server {

/// What serves a command of the table.
using Handler = void (*)(Hub& hub, const Request& request);
using Handlers = std::map<std::string_view, Handler>;

[[nodiscard]] const Handlers& hub_handlers();       ///< machines and who is at them
[[nodiscard]] const Handlers& panel_handlers();     ///< breakpoints, and what is taught
[[nodiscard]] const Handlers& memory_handlers();    ///< variables, offsets, tools, settings
[[nodiscard]] const Handlers& view_handlers();      ///< what is looked at: instants, speeds, pulses
[[nodiscard]] const Handlers& library_handlers();   ///< the programs on disk
[[nodiscard]] const Handlers& training_handlers();  ///< exercises and what a program is worth

/// A key of the panel as the machine takes it. Failure (usage): its arguments do not go together.
[[nodiscard]] base::Outcome<machine::Operation> key_of(const Request& request);
/// What a machine answers to a key: nothing but that it is done.
[[nodiscard]] base::Outcome<Json> done(const base::Outcome<void>& outcome);
/// Serves a key that needs nothing but the machine.
void press(Hub& hub, const Request& request);

/// Null: nothing serves this command.
[[nodiscard]] Handler find_handler(std::string_view command);

}  // namespace kerf::server
