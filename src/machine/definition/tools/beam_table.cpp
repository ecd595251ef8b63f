#include "machine/definition/tools/beam_table.hpp"

namespace kerf::machine {
namespace {

tl::unexpected<base::Failure> wrong_in(const std::string& source, const toml::node& node,
                                       const std::string& what) {
  return tl::unexpected(
      base::Failure{base::Failure::Kind::input,
                    source + ":" + std::to_string(node.source().begin.line) + ": " + what});
}

}  // namespace

base::Outcome<std::optional<double>> read_beam_table(const toml::table& file,
                                                     const std::string& source) {
  std::optional<double> kerf;
  const toml::node* const node = file.get("beam");
  if (node == nullptr) return kerf;
  if (!node->is_table()) return wrong_in(source, *node, "beam must be a table");
  for (const auto& [key, value] : *node->as_table()) {
    if (key.str() != "kerf")
      return wrong_in(source, value, "a beam has no key " + std::string(key.str()));
    kerf = value.is_number() ? value.value<double>() : std::nullopt;
    constexpr double kMost_mm = 1000;
    if (!kerf || !(*kerf > 0 && *kerf <= kMost_mm))
      return wrong_in(source, value, "kerf is the width of a cut, above 0 and at most 1000 mm");
  }
  return kerf;
}

}  // namespace kerf::machine
