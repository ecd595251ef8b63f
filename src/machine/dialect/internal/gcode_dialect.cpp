#include "machine/dialect/internal/gcode_dialect.hpp"

#include <cmath>
#include <filesystem>

#include "base/decimal.hpp"
#include "base/program_name.hpp"
#include "control/core/assumed.hpp"
#include "lang/vm/value.hpp"

namespace kerf::machine {
namespace {

constexpr double kMostVariable = 999999;

std::uint32_t number_of_common(std::size_t index) {
  const auto common = static_cast<std::uint32_t>(index);
  return common < gcode::kVolatileCommons ? 100 + common : 500 + common - gcode::kVolatileCommons;
}

}  // namespace

std::optional<std::uint32_t> GcodeDialect::number_of_variable(const std::string& name) {
  if (name.size() < 2 || name[0] != '#') return std::nullopt;
  const auto number = base::read_number(name.substr(1));
  if (!number || *number < 0 || *number > kMostVariable || *number != std::floor(*number))
    return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

GcodeDialect::GcodeDialect(const Around& around)
    : Dialect(around.sources),
      memory_(around.memory),
      sources_(around.sources),
      signals_(around.signals),
      library_(around.sources, around.pages),
      shelf_(around.sources, library_),
      controller_(around.definition.parameters, around.definition.axes, around.memory, library_,
                  shelf_, around.surroundings, around.sink) {
  first_locals_.fill(vm::kNull);
}

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
  controller_.start(vm::CodeId{0});
  tell_unread_text();
  const std::span<double> locals = controller_.running_locals();
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (!vm::is_null(first_locals_[i])) locals[i] = first_locals_[i];
  }
  first_locals_.fill(vm::kNull);
  started_ = true;
  return std::nullopt;
}

void GcodeDialect::tell_unread_text() {
  constexpr std::array<const char*, 3> kWords = {
      "what stands before this %, which begins the tape, is not read",
      "what stands behind this % in its line is not read",
      "what stands behind this %, which ends the tape, is not read"};
  for (const gcode::UnreadText& text : library_.unread()) {
    const auto where = static_cast<std::uint32_t>(text.where);
    controller_.assume(control::Assumed::unread_text + where, text.line, kWords[where]);
  }
}

std::optional<base::Diagnostic> GcodeDialect::start_entry(base::FileId file) {
  const std::size_t before = library_.program_count();
  const std::size_t findings = library_.findings().size();
  library_.add_file(file);
  if (library_.findings().size() > findings) return library_.findings().back();
  if (library_.program_count() == before)
    return base::make_error(base::Code::empty_program, {.file = file, .line = 1, .column = 1});
  controller_.start(vm::CodeId(before), control::GcodeControl::Ends::with_text);
  started_ = true;
  return std::nullopt;
}

void GcodeDialect::reset() {
  controller_.reset();
  started_ = false;
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

base::Outcome<void> GcodeDialect::set_variable(const std::string& name, double value) {
  const auto number = number_of_variable(name);
  if (!number)
    return tl::unexpected(base::Failure{base::Failure::Kind::usage, "'#NUMBER=VALUE' is expected"});
  if (const auto set = signals_.set(*number, value)) return *set;
  if (!started_ && *number > 0 && *number < gcode::kLocals) {
    first_locals_[*number] = value;
    return {};
  }
  return controller_.set_variable(*number, value);
}

std::vector<Variable> GcodeDialect::variables() {
  std::vector<Variable> list;
  const auto put = [&](std::size_t number, double value) {
    if (!vm::is_null(value)) list.push_back({"#" + std::to_string(number), value});
  };
  const std::span<double> locals = controller_.first_level_locals();
  for (std::size_t i = 1; i < locals.size(); ++i) put(i, locals[i]);
  for (std::size_t i = 0; i < memory_.commons.size(); ++i)
    put(number_of_common(i), memory_.commons[i]);
  return list;
}

}  // namespace kerf::machine
