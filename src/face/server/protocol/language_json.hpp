#pragma once

#include <string_view>

#include "base/language.hpp"
#include "control/core/parameters.hpp"
#include "face/server/protocol/json.hpp"

namespace kerf::server {

/// The dialects that Kerf runs, with what a page wants to know of their languages.
[[nodiscard]] Json dialects_json();
/// Names of the kinds of tokens; tokens_json() has their places in this list.
[[nodiscard]] Json token_kinds_json();

/// The tokens of lines that stand between line feeds: a list for each line, of kind and length of
/// its tokens in turn. Lengths are UTF-16 units, as pages and editors count.
[[nodiscard]] Json tokens_json(const base::Language& language, std::string_view lines);

/// The groups of modal G codes that the dialect has, with their numbers behind #40 and their codes,
/// in the order in which they are shown. The system of G codes is one of the parameters.
[[nodiscard]] Json modal_groups_json(std::string_view dialect,
                                     const control::Parameters& parameters);

}  // namespace kerf::server
