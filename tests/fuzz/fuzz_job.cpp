// Any bytes as a job file: sentences with a place in it, or a recipe in which nothing contradicts
// itself. Its lines as KEY=VALUE of --job-set: a sentence and no change, or another recipe. The
// same bytes as a file of materials, which fill operations, and as words of a text.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "process/job_texts.hpp"
#include "process/materials.hpp"
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

void check_materials(const std::string& text) {
  process::MachineFacts machine;
  machine.max_power_w = 60;
  const auto materials = process::read_materials(text, "materials.toml", kFile);
  if (!materials) {
    for (const base::Diagnostic& each : materials.error()) {
      check_sentence(each);
      require(each.place.line > 0);
    }
    return;
  }
  for (const process::Material& each : *materials) {
    require(!each.name.empty() && process::find_material(each.name, *materials, {}));
    process::Operation operation;
    (void)process::fill_in(operation, &each, machine);
    require(!operation.power_percent || *operation.power_percent <= 100);
    require(!operation.feed || *operation.feed > 0);
  }
}

void check_words(const std::string& text) {
  const auto filled = process::filled_words(text, {{"serial", "1"}, {"a", "b"}}, {});
  if (!filled) require(filled.error().code == base::Code::job_text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  process::Recipe recipe = read(text);
  if (recipe.operations.empty()) {
    process::Operation& operation = recipe.operations.emplace_back();
    operation.name = "a";
    operation.layers = {"*"};
  }
  check_materials(text);
  check_words(text);
  std::size_t at = 0;
  for (std::size_t i = 0; i < kMostLines && at < text.size(); ++i) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    check_setting(recipe, std::string_view(text).substr(at, end - at));
    at = end + 1;
  }
  return 0;
}
