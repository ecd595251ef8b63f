#pragma once

#include <string>

#include "base/findings.hpp"
#include "base/text_window.hpp"
#include "lang/vm/page_store.hpp"
#include "machine/dialect/internal/pattern_page.hpp"

namespace kerf::machine {

/// The listing of a pattern (docs/pattern.md, "Listing") as a program of the virtual machine, a
/// line a block, compiled page by page when it is reached. A wrong line is PATTERN_TEXT when it is
/// reached, and so is one of more than kMostRecords records, which only a person writes.
class PatternLibrary : public vm::CodeSource {
 public:
  /// Every file is this one program.
  static constexpr vm::CodeId kProgram{0};
  /// Most that one line may be. A cut of so many has 30,000 pulses of an arm.
  static constexpr std::int64_t kMostRecords = 1000;

  PatternLibrary(const base::SourceSet& sources, const vm::PageSettings& settings);

  /// The file that is the program from here on.
  void load(base::FileId file);
  [[nodiscard]] bool loaded() const { return file_ != base::kNoFile; }

  /// All mistakes of the file, in the order of its lines.
  void check(const std::string& program, base::Findings& found);

  // vm::CodeSource
  PatternPage& page(vm::CodeId code, std::uint32_t number) override;
  /// There are none.
  std::optional<vm::Address> find_label(vm::CodeId code, vm::Address from,
                                        std::uint32_t label) override;
  vm::Region resolve_region(vm::CodeId code, std::uint32_t page, std::uint32_t region) override;

 private:
  PatternPage& compile_next();
  void compile_line(const base::TextWindow::Line& line, std::uint32_t number, PatternPage& page);

  const base::SourceSet& sources_;
  vm::PageSettings settings_;
  vm::PageStore<PatternPage> pages_;
  base::TextWindow window_;
  std::uint32_t next_page_ = 0;    // behind the one that was compiled last
  std::uint64_t next_offset_ = 0;  // where it begins
  std::uint32_t next_line_ = 1;
  base::FileId file_ = base::kNoFile;
};

}  // namespace kerf::machine
