#include "machine/dialect/internal/motion_dialect.hpp"

#include <utility>

namespace kerf::machine {
namespace {

control::RecordedFor recorded_for(const MachineDefinition& machine) {
  using motion::SpindleName;
  control::RecordedFor self;
  self.checks_strokes = machine.parameters.stroke_check && !machine.axes.linked;
  for (const SpindleName name : {SpindleName::live, SpindleName::sub}) {
    const auto* const spindle = machine.parameters.machine_codes.find(name);
    if (spindle != nullptr) self.most_rpm[index(name)] = spindle->most_rpm;
  }
  self.most_rpm[index(SpindleName::main)] = machine.parameters.spindle_max_rpm;
  return self;
}

}  // namespace

MotionDialect::MotionDialect(const Around& around)
    : Dialect(around.sources),
      sources_(around.sources),
      library_(around.sources, *this, around.definition.axes, around.pages),
      control_(around.definition.axes, recorded_for(around.definition), library_, around.memory,
               around.surroundings, around.sink) {}

void MotionDialect::load_file(base::FileId file) {
  library_.load(file);
  name_ = library_.program_name();
}

// What they hold is not known here: their name alone is.
base::FileId MotionDialect::id_of(const std::string& name) {
  const auto found = files_.find(name);
  if (found != files_.end()) return found->second;
  if (files_.size() >= kMostFiles) return base::kNoFile;
  return files_[name] = sources_.add(base::SourceFile::from_text(name, ""));
}

std::optional<base::Diagnostic> MotionDialect::start() {
  if (!library_.loaded()) return base::make_error(base::Code::empty_program, {});
  control_.start(program_name());
  return std::nullopt;
}

void MotionDialect::check(base::Findings& found) {
  if (library_.loaded()) library_.check(program_name(), found);
}

}  // namespace kerf::machine
