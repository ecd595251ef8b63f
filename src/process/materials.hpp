#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "process/machine_facts.hpp"
#include "process/material.hpp"
#include "process/recipe_file.hpp"

namespace kerf::process {

/// A file of materials/, as text.
struct BuiltinMaterials {
  std::string_view name;
  std::string_view toml;
};
[[nodiscard]] const std::vector<BuiltinMaterials>& builtin_material_files();

/// Those that Kerf knows, in the order of their files.
[[nodiscard]] const std::vector<Material>& builtin_materials();

/// The materials of a file, or what is wrong with it: JOB_KEY and JOB_VALUE with line and column.
[[nodiscard]] tl::expected<std::vector<Material>, Diagnostics> read_materials(
    const std::string& text, const std::string& source, base::FileId file);

/// The last one of that name in `more`, else the one that Kerf knows. MATERIAL_UNKNOWN at `place`,
/// with the nearest name.
[[nodiscard]] tl::expected<const Material*, base::Diagnostic> find_material(
    std::string_view name, std::span<const Material> more, const base::Place& place);

/// What a material says of a process, null where that is nothing: mark, fill and raster without
/// something of their own are as engrave.
[[nodiscard]] const Preset* preset_of(const Material& material, Process process);

/// Fills what an operation leaves out from the material, else from the machine. Watts become
/// percent of the machine's; where that is more than all of it, the feed falls by the same factor,
/// so that the energy stays, and PRESET_SCALED says so. What neither says stays empty: settle()
/// assumes it and tells. A process to which something is missing that nobody may assume (the width
/// of a track) is JOB_VALUE.
[[nodiscard]] Diagnostics fill_in(Operation& operation, const Material* material,
                                  const MachineFacts& machine);
/// Likewise all operations of a recipe, whose material is looked for; MATERIAL_UNKNOWN.
[[nodiscard]] Diagnostics fill_in(Recipe& recipe, std::span<const Material> more,
                                  const MachineFacts& machine);

}  // namespace kerf::process
