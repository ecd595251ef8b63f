#pragma once

#include <string_view>

#include "features/tree/tree.hpp"

namespace kerf::features {

// What reports and edits call things: "outside-profile".
[[nodiscard]] std::string_view word_of(FeatureType type);
[[nodiscard]] std::string_view word_of(Order order);
[[nodiscard]] std::string_view word_of(Strategy strategy);
[[nodiscard]] std::string_view word_of(Milling milling);
[[nodiscard]] std::string_view word_of(Entry::Kind kind);
[[nodiscard]] std::string_view word_of(Entry::Lead lead);
[[nodiscard]] std::string_view word_of(Origin::Kind kind);
[[nodiscard]] std::string_view word_of(Editable editable);
[[nodiscard]] std::string_view word_of(Cut::Role role);
[[nodiscard]] std::string_view word_of(RelationKind kind);
[[nodiscard]] std::string_view word_of(LiteralWord::Type type);
[[nodiscard]] std::string_view word_of(Reason reason);
[[nodiscard]] std::string_view word_of(TurnedElement::Kind kind);
[[nodiscard]] std::string_view word_of(HoleStep::How how);
[[nodiscard]] std::string_view word_of(Hole::Form form);
[[nodiscard]] std::string_view word_of(Pattern::Kind kind);
[[nodiscard]] std::string_view word_of(Unrecognised::Why why);

}  // namespace kerf::features
