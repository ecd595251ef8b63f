#include "machine/dialect.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "machine/internal/basic_dialect.hpp"
#include "machine/internal/gcode_dialect.hpp"
#include "machine/internal/teach_dialect.hpp"

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
constexpr std::array kMakers = {Maker{"fanuc-mill", make<GcodeDialect>},
                                Maker{"laser-basic", make<BasicDialect>},
                                Maker{"teach", make<TeachDialect>}};

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

std::unique_ptr<Dialect> make_dialect(std::string_view name, const Dialect::Around& around) {
  const auto maker = std::find_if(kMakers.begin(), kMakers.end(),
                                  [&](const Maker& candidate) { return candidate.name == name; });
  assert(maker != kMakers.end());
  return maker->make(around);
}

}  // namespace kerf::machine
