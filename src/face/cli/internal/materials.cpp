#include "process/materials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"

namespace kerf::cli {
namespace {

bool is_in(const process::BuiltinMaterials& file, const std::string& name) {
  const auto read = process::read_materials(std::string(file.toml), std::string(file.name), {});
  return read && std::any_of(read->begin(), read->end(), [&](const process::Material& material) {
           return material.name == name;
         });
}

}  // namespace

ExitStatus materials(const std::string& name) {
  if (name.empty()) {
    for (const process::Material& material : process::builtin_materials())
      fmt::print("{:<22}{}\n", material.name, material.text);
    return ExitStatus::well;
  }
  for (const process::BuiltinMaterials& file : process::builtin_material_files()) {
    if (!is_in(file, name)) continue;
    fmt::print("{}", file.toml);
    return ExitStatus::well;
  }
  return fail({base::Failure::Kind::usage,
               "there is no built-in material " + name + "; `kerf materials` lists them"});
}

}  // namespace kerf::cli
