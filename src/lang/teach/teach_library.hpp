#pragma once

#include <string>

#include "base/findings.hpp"
#include "lang/teach/page_compiler.hpp"
#include "lang/vm/page_store.hpp"

namespace kerf::teach {

/// One .tch file as a program of the virtual machine, compiled page by page when it is reached. A
/// file of any length runs in the memory of some pages: programs run straight on, so nothing is
/// kept of those that are past.
class TeachLibrary : public vm::CodeSource {
 public:
  /// Every file is this one program.
  static constexpr vm::CodeId kProgram{0};

  TeachLibrary(const base::SourceSet& sources, const vm::PageSettings& settings);

  /// The file that is the program from here on.
  void load(base::FileId file);
  [[nodiscard]] bool loaded() const { return file_ != base::kNoFile; }
  [[nodiscard]] base::FileId file() const { return file_; }

  /// All mistakes of the file, in the order of its lines.
  void check(const std::string& program, base::Findings& found);

  // vm::CodeSource
  TeachPage& page(vm::CodeId code, std::uint32_t number) override;
  /// There are none.
  std::optional<vm::Address> find_label(vm::CodeId code, vm::Address from,
                                        std::uint32_t label) override;
  vm::Region resolve_region(vm::CodeId code, std::uint32_t page, std::uint32_t region) override;

 private:
  TeachPage& compile_next(vm::CodeId code);

  const base::SourceSet& sources_;
  vm::PageSettings settings_;
  PageCompiler compiler_;
  vm::PageStore<TeachPage> pages_;
  std::uint32_t next_page_ = 0;  // behind the one that was compiled last
  RecordReader::Position next_;  // where it begins
  base::FileId file_ = base::kNoFile;
};

}  // namespace kerf::teach
