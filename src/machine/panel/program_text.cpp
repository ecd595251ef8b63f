#include "machine/panel/program_text.hpp"

#include <utility>

namespace kerf::machine {

ProgramText ProgramText::of(std::string name, std::string text) {
  return {std::move(name), std::make_shared<const std::string>(std::move(text))};
}

base::Outcome<std::unique_ptr<base::SourceFile>> ProgramText::open() const {
  if (text == nullptr) return base::SourceFile::open(name);
  return base::SourceFile::from_shared(name, text);
}

}  // namespace kerf::machine
