#include "machine/dialect/dialect.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "machine/dialect/internal/basic_dialect.hpp"
#include "machine/dialect/internal/gcode_dialect.hpp"
#include "machine/dialect/internal/pattern_dialect.hpp"
#include "machine/dialect/internal/teach_dialect.hpp"
#include "machine/dialect/language.hpp"

namespace kerf::machine {
namespace {

template <typename Made>
std::unique_ptr<Dialect> make(const Dialect::Around& around) {
  return std::make_unique<Made>(around);
}

struct Maker {
  std::string_view name;
  std::unique_ptr<Dialect> (*make)(const Dialect::Around& around);
};
constexpr std::array kMakers = {
    Maker{"fanuc-mill", make<GcodeDialect>}, Maker{"laser-basic", make<BasicDialect>},
    Maker{"teach", make<TeachDialect>}, Maker{kPatternDialect, make<PatternDialect>}};

const Maker* find_maker(std::string_view name) {
  const auto maker = std::find_if(kMakers.begin(), kMakers.end(),
                                  [&](const Maker& candidate) { return candidate.name == name; });
  return maker == kMakers.end() ? nullptr : &*maker;
}

}  // namespace

bool Dialect::is_file(const std::string& name, base::FileId file) const {
  if (!sources_.contains(file)) return false;
  const std::string& whole = sources_[file].name();
  return whole == name || (whole.size() > name.size() && whole.ends_with(name) &&
                           whole[whole.size() - name.size() - 1] == '/');
}

std::vector<std::string_view> available_dialects() {
  std::vector<std::string_view> names;
  for (const Maker& maker : kMakers) names.push_back(maker.name);
  return names;
}

base::Outcome<void> check_dialect(const MachineDefinition& machine, std::string_view dialect) {
  if (find_maker(dialect) == nullptr) {
    return tl::unexpected(
        base::Failure{base::Failure::Kind::usage,
                      "Kerf does not run the language '" + std::string(dialect) + "'"});
  }
  if (dialect != kPatternDialect) return {};
  const auto counting = PatternMachine::of(machine);
  if (!counting) return tl::unexpected(counting.error());
  return {};
}

std::unique_ptr<Dialect> make_dialect(std::string_view name, const Dialect::Around& around) {
  const Maker* const maker = find_maker(name);
  assert(maker != nullptr);
  return maker->make(around);
}

}  // namespace kerf::machine
