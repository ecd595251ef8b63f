// Any bytes as a job file: sentences with a place in it, or a recipe in which nothing contradicts
// itself. Its lines as KEY=VALUE of --job-set: a sentence and no change, or another recipe.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "process/recipe_file.hpp"

namespace {

using namespace kerf;

constexpr std::size_t kMostLines = 200;
constexpr base::FileId kFile{1};

void require(bool condition) {
  if (!condition) std::abort();
}

void check_sentence(const base::Diagnostic& diagnostic) {
  require(diagnostic.code == base::Code::job_key || diagnostic.code == base::Code::job_value);
  require(!diagnostic.message.empty());
}

void check_recipe(const process::Recipe& recipe) {
  require(recipe.array.copies() > 0 && recipe.array.copies() <= 100'000);
  require(recipe.tolerance > 0 && recipe.tolerance <= 10);
  for (const process::Operation& each : recipe.operations) {
    require(!each.name.empty() && !each.layers.empty() && each.passes > 0);
    require(!each.feed || (*each.feed > 0 && std::isfinite(*each.feed)));
    require(!each.power_percent || (*each.power_percent >= 0 && *each.power_percent <= 100));
  }
}

process::Recipe read(const std::string& text) {
  const auto read = process::read_recipe(text, "job.toml", kFile);
  if (read) {
    require(process::contradictions(*read).empty());
    check_recipe(*read);
    return *read;
  }
  require(!read.error().empty() && read.error().size() <= 100);
  for (const base::Diagnostic& each : read.error()) {
    check_sentence(each);
    require(each.place.file == kFile && each.place.line > 0);
  }
  return {};
}

void check_setting(process::Recipe& recipe, std::string_view line) {
  const std::size_t equals = std::min(line.find('='), line.size());
  const std::string_view value = line.substr(std::min(equals + 1, line.size()));
  for (const base::Diagnostic& each : process::set(recipe, line.substr(0, equals), value))
    check_sentence(each);
  for (const process::Operation& each : recipe.operations)
    require(!each.name.empty() && !each.layers.empty() && each.passes > 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  process::Recipe recipe = read(text);
  if (recipe.operations.empty()) recipe.operations.push_back({.name = "a", .layers = {"*"}});
  std::size_t at = 0;
  for (std::size_t i = 0; i < kMostLines && at < text.size(); ++i) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    check_setting(recipe, std::string_view(text).substr(at, end - at));
    at = end + 1;
  }
  return 0;
}
