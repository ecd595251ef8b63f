#include "machine/panel/panel.hpp"

#include <algorithm>
#include <array>

namespace kerf::machine {
namespace {

constexpr std::array<std::string_view, 6> kModes = {"edit", "mdi", "auto", "jog", "ref", "teach"};
constexpr std::array<std::string_view, kSwitches> kSwitchNames = {"single-block", "optional-stop",
                                                                  "dry-run", "machine-lock"};
constexpr std::array<std::string_view, 7> kStatuses = {"idle", "running", "held", "stopped",
                                                       "step", "end",     "alarm"};

template <typename Named, std::size_t kCount>
std::optional<Named> find(const std::array<std::string_view, kCount>& names,
                          std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Named>(found - names.begin());
}

}  // namespace

std::string_view name_of(Mode mode) { return kModes[static_cast<std::size_t>(mode)]; }
std::string_view name_of(Switch which) { return kSwitchNames[static_cast<std::size_t>(which)]; }
std::string_view name_of(Status status) { return kStatuses[static_cast<std::size_t>(status)]; }
std::vector<std::string_view> mode_names() { return {kModes.begin(), kModes.end()}; }
std::vector<std::string_view> switch_names() { return {kSwitchNames.begin(), kSwitchNames.end()}; }
std::optional<Mode> mode_named(std::string_view name) { return find<Mode>(kModes, name); }
std::optional<Switch> switch_named(std::string_view name) {
  return find<Switch>(kSwitchNames, name);
}

}  // namespace kerf::machine
