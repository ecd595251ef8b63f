#include "features/tree/words.hpp"

#include <array>
#include <cstddef>

namespace kerf::features {
namespace {

template <std::size_t N, typename Word>
std::string_view nth(const std::array<std::string_view, N>& words, Word word) {
  return words[static_cast<std::size_t>(word)];
}

}  // namespace

std::string_view word_of(FeatureType type) {
  static constexpr std::array<std::string_view, 19> kWords = {
      "thread", "surface",     "chamfer",         "engraving",      "slot",
      "groove", "face",        "outside-profile", "inside-profile", "boss",
      "pocket", "step",        "open-pocket",     "facing",         "turning",
      "boring", "face-groove", "parting",         "drilling"};
  return nth(kWords, type);
}

std::string_view word_of(Order order) {
  static constexpr std::array<std::string_view, 3> kWords = {"undefined", "inside-out",
                                                             "outside-in"};
  return nth(kWords, order);
}

std::string_view word_of(Strategy strategy) {
  static constexpr std::array<std::string_view, 7> kWords = {
      "single", "contour-parallel", "zig", "zig-zag", "spiral", "trochoidal", "adaptive"};
  return nth(kWords, strategy);
}

std::string_view word_of(Milling milling) {
  static constexpr std::array<std::string_view, 4> kWords = {"undefined", "climb", "conventional",
                                                             "both"};
  return nth(kWords, milling);
}

std::string_view word_of(Entry::Kind kind) {
  static constexpr std::array<std::string_view, 5> kWords = {"plunge", "ramp", "helix", "outside",
                                                             "rapid"};
  return nth(kWords, kind);
}

std::string_view word_of(Entry::Lead lead) {
  static constexpr std::array<std::string_view, 3> kWords = {"none", "line", "arc"};
  return nth(kWords, lead);
}

std::string_view word_of(Origin::Kind kind) {
  static constexpr std::array<std::string_view, 8> kWords = {
      "literal", "once", "shared", "loop", "expression", "cycle-list", "cycle-shape", "mixed"};
  return nth(kWords, kind);
}

std::string_view word_of(Editable editable) {
  static constexpr std::array<std::string_view, 5> kWords = {"contour", "shared", "unroll",
                                                             "argument", "no"};
  return nth(kWords, editable);
}

std::string_view word_of(Cut::Role role) {
  static constexpr std::array<std::string_view, 4> kWords = {"only", "rough", "finish", "rest"};
  return nth(kWords, role);
}

std::string_view word_of(RelationKind kind) {
  static constexpr std::array<std::string_view, 4> kWords = {"nested", "island", "edge", "crosses"};
  return nth(kWords, kind);
}

std::string_view word_of(LiteralWord::Type type) {
  static constexpr std::array<std::string_view, 3> kWords = {"pocket", "side-milling", "hole"};
  return nth(kWords, type);
}

std::string_view word_of(Reason reason) {
  static constexpr std::array<std::string_view, 9> kWords = {
      "tool-assumed", "stock-assumed", "ring-by-default",  "methods-differ",      "adaptive",
      "surface",      "no-material",   "entered-by-rapid", "nose-not-compensated"};
  return nth(kWords, reason);
}

std::string_view word_of(TurnedElement::Kind kind) {
  static constexpr std::array<std::string_view, 5> kWords = {"cylinder", "shoulder", "chamfer",
                                                             "taper", "radius"};
  return nth(kWords, kind);
}

std::string_view word_of(HoleStep::How how) {
  static constexpr std::array<std::string_view, 8> kWords = {
      "spot", "drill", "ream", "bore", "tap", "mill", "helix", "countersink"};
  return nth(kWords, how);
}

std::string_view word_of(Hole::Form form) {
  static constexpr std::array<std::string_view, 7> kWords = {
      "plain", "spot", "counterbore", "countersink", "stepped", "tapped", "threaded"};
  return nth(kWords, form);
}

std::string_view word_of(Pattern::Kind kind) {
  static constexpr std::array<std::string_view, 4> kWords = {"line", "grid", "circle", "list"};
  return nth(kWords, kind);
}

std::string_view word_of(Unrecognised::Why why) {
  static constexpr std::array<std::string_view, 6> kWords = {
      "free-motion", "rotary", "probing", "air", "above-assumed-stock", "budget"};
  return nth(kWords, why);
}

}  // namespace kerf::features
