#include "face/server/hub/internal/program_source.hpp"

#include "face/server/protocol/pattern_text.hpp"

namespace kerf::server {

base::Outcome<base::ProgramText> text_of(const Library& library, const LoadedProgram& program,
                                         const machine::MachineDefinition& machine) {
  if (program.text) return base::ProgramText::of(program.name, *program.text);
  auto path = library.path_of(program.name);
  if (!path) return tl::unexpected(path.error());
  if (!is_pattern(program.name)) return base::ProgramText::at_path(*path);
  const auto file = base::SourceFile::open(*path);
  if (!file) return tl::unexpected(file.error());
  auto listing = listing_of(**file, program.name, machine.pattern.byte_order);
  if (!listing) return tl::unexpected(listing.error());
  return base::ProgramText::of(program.name, std::move(*listing));
}

}  // namespace kerf::server
