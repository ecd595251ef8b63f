#include "face/cli/setting.hpp"

#include "face/cli/failure.hpp"

namespace kerf::cli {

base::Outcome<Setting> split_setting(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return usage(option + " " + text + ": KEY=VALUE is expected");
  return Setting{text.substr(0, equals), text.substr(equals + 1)};
}

base::Outcome<void> set_machine_keys(const std::vector<std::string>& keys,
                                     machine::MachineDefinition& definition) {
  for (const std::string& text : keys) {
    auto setting = split_setting(text, "--machine-set");
    if (!setting) return tl::unexpected(setting.error());
    if (auto set = definition.set(setting->key, setting->value); !set) return set;
  }
  return {};
}

}  // namespace kerf::cli
