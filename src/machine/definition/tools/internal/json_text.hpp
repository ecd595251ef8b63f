#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kerf::machine {

/// A file of another program. What lies deeper than any library goes is left out, so that the
/// memory is a small multiple of the text's; a text that is no JSON is a discarded value, which has
/// no members.
[[nodiscard]] inline nlohmann::json parse_library(const std::string& text) {
  constexpr int kDeepest = 30;
  const auto keep = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    return depth < kDeepest;
  };
  return nlohmann::json::parse(text, keep, false);
}

}  // namespace kerf::machine
