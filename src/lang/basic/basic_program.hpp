#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/findings.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "base/text_window.hpp"
#include "lang/basic/emitter.hpp"
#include "lang/basic/page.hpp"
#include "lang/basic/scan.hpp"
#include "lang/vm/page_store.hpp"

namespace kerf::basic {

/// A laser BASIC program: read once as a whole for its labels, variables and loops, then compiled
/// page by page when it is reached.
class BasicProgram : public vm::CodeSource {
 public:
  static constexpr vm::CodeId kCode{0};

  BasicProgram(const base::SourceSet& sources, const vm::PageSettings& settings)
      : sources_(sources), settings_(settings), pages_(settings) {}

  void load(base::FileId file);
  [[nodiscard]] bool loaded() const { return file_ != base::kNoFile; }

  /// What keeps the program from running: LB0007, LB0014, LB0020, LB0021, LB0026.
  [[nodiscard]] const std::vector<base::Diagnostic>& findings() const { return scan_.findings; }
  /// These, and all statements that do not compile, in the order of the lines.
  void check(const std::string& program, base::Findings& found);

  /// Names in capitals, by their numbers; the first kNear live in registers.
  [[nodiscard]] const std::vector<std::string>& variables() const { return scan_.variable_names; }
  [[nodiscard]] std::optional<std::uint32_t> find_variable(const std::string& capitals) const;

  /// Compiles an expression ("a>5 AND b=0"), true where it is not 0, for vm::Evaluation. Otherwise
  /// what is wrong with it: also a variable that the program does not have.
  [[nodiscard]] base::Result<std::unique_ptr<BasicPage>> compile_condition(
      const std::string& text) const;

  // vm::CodeSource
  BasicPage& page(vm::CodeId code, std::uint32_t number) override;
  std::optional<vm::Address> find_label(vm::CodeId code, vm::Address from,
                                        std::uint32_t label) override;
  vm::Region resolve_region(vm::CodeId code, std::uint32_t page, std::uint32_t region) override;

 private:
  void compile(std::uint32_t number, BasicPage& page);
  [[nodiscard]] std::uint32_t page_of(std::uint32_t label) const;

  const base::SourceSet& sources_;
  vm::PageSettings settings_;
  vm::PageStore<BasicPage> pages_;
  base::FileId file_ = base::kNoFile;
  Scan scan_;
  std::vector<bool> compiled_;  // pages that have been at least once
  Emitter::Known early_;        // what the first page writes before any way parts
  base::TextWindow window_;
  std::vector<Label> sorted_labels_;  // of the newest page
};

}  // namespace kerf::basic
