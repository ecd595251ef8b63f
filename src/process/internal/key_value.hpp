#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>

#include "process/keys.hpp"

namespace kerf::process {

/// What a node of a TOML file says to a key; nothing where the key does not take it. Not for
/// tables.
[[nodiscard]] std::optional<KeyValue> value_of(const Takes& takes, const toml::node& node);

/// A scalar for a sentence; of all else what kind it is.
[[nodiscard]] std::string shown_value(const toml::node& node);

}  // namespace kerf::process
