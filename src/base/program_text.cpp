#include "base/program_text.hpp"

#include <utility>

namespace kerf::base {

ProgramText ProgramText::of(std::string name, std::string text) {
  return {std::move(name), std::make_shared<const std::string>(std::move(text))};
}

Outcome<std::unique_ptr<SourceFile>> ProgramText::open() const {
  if (text == nullptr) return SourceFile::open(name);
  return SourceFile::from_shared(name, text);
}

}  // namespace kerf::base
