#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>

#include "base/result.hpp"
#include "machine/definition/internal/takes.hpp"

namespace kerf::machine {

/// What a scalar says, as a parameter of the control takes it.
[[nodiscard]] std::string text_of(const toml::node& node);

/// The value of a key, or nothing when it does not take this one.
[[nodiscard]] std::optional<double> value_of(const Takes& takes, const toml::node& node);

/// Failure (input) at the line of `node`; null: of the whole file.
[[nodiscard]] tl::unexpected<base::Failure> wrong_at(const std::string& source,
                                                     const toml::node* node,
                                                     const std::string& what);

}  // namespace kerf::machine
