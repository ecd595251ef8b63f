#include "machine/dialect/internal/gcode_dialect.hpp"

#include <filesystem>

#include "base/program_name.hpp"
#include "control/core/assumed.hpp"

namespace kerf::machine {
GcodeDialect::GcodeDialect(const Around& around, const control::CodeTable& codes)
    : Dialect(around.sources),
      sources_(around.sources),
      library_(around.sources, around.pages),
      shelf_(around.sources, library_),
      control_(codes, around.definition.parameters, around.definition.axes, around.memory, library_,
               shelf_, around.surroundings, around.sink),
      variables_(around.memory, around.signals, library_, control_) {}

void GcodeDialect::load_file(base::FileId file) {
  const std::string& name = sources_[file].name();
  if (name != "-") {
    shelf_.know(name);
    shelf_.add_folder(std::filesystem::path(name).parent_path().string());
  }
  library_.add_file(file);
}

std::string GcodeDialect::program_name() const {
  if (library_.program_count() == 0) return base::kUnnumberedProgram;
  return gcode::name_of(library_.entry(vm::CodeId{0}));
}

// Alarms in the structure of the file (PS0073, PS0074) come before its first block.
std::optional<base::Diagnostic> GcodeDialect::start() {
  if (!library_.findings().empty()) return library_.findings().front();
  return start_all_the_same();
}

std::optional<base::Diagnostic> GcodeDialect::start_all_the_same() {
  if (library_.program_count() == 0)
    return base::make_error(base::Code::empty_program,
                            {.file = main_file(), .line = 1, .column = 1});
  control_.start(vm::CodeId{0});
  tell_unread_text();
  variables_.begin();
  return std::nullopt;
}

void GcodeDialect::tell_unread_text() {
  constexpr std::array<const char*, 3> kWords = {
      "what stands before this %, which begins the tape, is not read",
      "what stands behind this % in its line is not read",
      "what stands behind this %, which ends the tape, is not read"};
  for (const gcode::UnreadText& text : library_.unread()) {
    const auto where = static_cast<std::uint32_t>(text.where);
    control_.assume(control::Assumed::unread_text + where, text.line, kWords[where]);
  }
}

std::optional<base::Diagnostic> GcodeDialect::start_entry(base::FileId file) {
  const std::size_t before = library_.program_count();
  const std::size_t findings = library_.findings().size();
  library_.add_file(file);
  if (library_.findings().size() > findings) return library_.findings().back();
  if (library_.program_count() == before)
    return base::make_error(base::Code::empty_program, {.file = file, .line = 1, .column = 1});
  control_.start(vm::CodeId(before), control::GcodeControl::Ends::with_text);
  variables_.begin_entry();
  return std::nullopt;
}

void GcodeDialect::reset() {
  control_.reset();
  variables_.end();
}

// Every block that does not compile, whether it is reached or not.
void GcodeDialect::check(base::Findings& found) {
  for (base::Diagnostic diagnostic : library_.findings()) {
    diagnostic.program = program_name();
    found.add(std::move(diagnostic));
  }
  for (std::size_t program = 0; program < library_.program_count() && !found.over(); ++program)
    library_.check(vm::CodeId(program), found);
}

}  // namespace kerf::machine
