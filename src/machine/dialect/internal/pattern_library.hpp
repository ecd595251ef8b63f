#pragma once

#include "base/text_window.hpp"
#include "lang/vm/straight_program.hpp"
#include "machine/dialect/internal/pattern_page.hpp"

namespace kerf::machine {

/// The listing of a pattern (docs/pattern.md, "Listing") as a program of the virtual machine, a
/// line a block. A wrong line is PATTERN_TEXT when it is reached, and so is one of more than
/// kMostRecords records, which only a person writes.
class PatternLibrary final : public vm::StraightProgram<PatternPage> {
 public:
  /// Most that one line may be. A cut of so many has 30,000 pulses of an arm.
  static constexpr std::int64_t kMostRecords = 1000;

  PatternLibrary(const base::SourceSet& sources, const vm::PageSettings& settings);

 private:
  // vm::StraightProgram
  void rewind() override;
  void compile(PatternPage& page) override;

  void compile_line(const base::TextWindow::Line& line, std::uint32_t number, PatternPage& page);

  const base::SourceSet& sources_;
  base::TextWindow window_;
  std::uint64_t next_offset_ = 0;  // where the next page begins
  std::uint32_t next_line_ = 1;
};

}  // namespace kerf::machine
