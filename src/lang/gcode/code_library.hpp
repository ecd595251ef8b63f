#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/findings.hpp"
#include "base/source_file.hpp"
#include "lang/gcode/loops.hpp"
#include "lang/gcode/name_table.hpp"
#include "lang/gcode/page_compiler.hpp"
#include "lang/gcode/pages_ahead.hpp"
#include "lang/gcode/program_directory.hpp"
#include "lang/vm/code_page.hpp"
#include "lang/vm/page_store.hpp"

namespace kerf::gcode {

/// All programs that a machine can call, compiled page by page when they are reached; pages are
/// kept in a bounded store.
class CodeLibrary : public vm::CodeSource {
 public:
  using Settings = vm::PageSettings;

  explicit CodeLibrary(base::SourceSet& sources) : CodeLibrary(sources, Settings{}) {}
  CodeLibrary(base::SourceSet& sources, const Settings& settings);
  ~CodeLibrary() override;

  /// Adds all programs of a file. The programs of the first file are found first.
  void add_file(base::FileId file);
  /// Adds the programs of a file that may be named after its only program ("O9401.nc").
  void add_library_file(base::FileId file, std::uint32_t number_from_name);

  /// What is wrong with the program numbers of the files.
  [[nodiscard]] const std::vector<base::Diagnostic>& findings() const { return findings_; }
  /// Text of the first file that is no part of its programs.
  [[nodiscard]] const std::vector<UnreadText>& unread() const { return unread_; }

  [[nodiscard]] std::size_t program_count() const { return programs_.size(); }
  [[nodiscard]] const ProgramEntry& entry(vm::CodeId code) const;
  [[nodiscard]] std::optional<vm::CodeId> find(std::uint32_t number) const;
  [[nodiscard]] std::optional<vm::CodeId> find(const std::string& name) const;
  /// The first program of this number that is not in `file`.
  [[nodiscard]] std::optional<vm::CodeId> find_outside(base::FileId file,
                                                       std::uint32_t number) const;
  /// Mistakes of a program that show without running it: blocks that do not compile, GOTOs to
  /// sequence numbers that do not exist (warnings: such a GOTO may never be reached), DOs without
  /// END. Ends early when `found` is over().
  void check(vm::CodeId code, base::Findings& found);

  [[nodiscard]] NameTable& names() { return names_; }

  // vm::CodeSource
  GcodePage& page(vm::CodeId code, std::uint32_t number) override;
  std::optional<vm::Address> find_label(vm::CodeId code, vm::Address from,
                                        std::uint32_t label) override;
  vm::Region resolve_region(vm::CodeId code, std::uint32_t page, std::uint32_t region) override;

 private:
  struct PlacedLabel {
    std::uint32_t number = 0;
    vm::Address at;
    friend auto operator<=>(const PlacedLabel&, const PlacedLabel&) = default;
  };
  struct Program {
    ProgramEntry entry;
    base::FileId file{};
    std::vector<PageStart> starts;                     ///< of the pages that are known so far
    bool complete = false;                             ///< the last page is among them
    std::optional<std::vector<PlacedLabel>> labels{};  ///< sorted by number, then address
    std::unique_ptr<LoopMatcher> loops{};              ///< once one leaves its page
    std::uint32_t matched_pages = 0;                   ///< whose marks have passed it
    std::map<vm::Address, LoopEnding> endings{};  ///< of DOs that leave their page, by page, region
  };
  Program& program(vm::CodeId code) { return programs_[static_cast<std::size_t>(code)]; }
  GcodePage& compile(vm::CodeId code, std::uint32_t number, bool seen_before);
  void look_ahead(const GcodePage& page);
  void learn_starts(vm::CodeId code, std::uint32_t number);
  const std::vector<PlacedLabel>& labels_of(vm::CodeId code);
  void check_page(vm::CodeId code, std::uint32_t number, base::Findings& found);
  void match_next_page(vm::CodeId code);
  void add_programs(base::FileId file, std::uint32_t number_from_name);

  base::SourceSet& sources_;
  PageCompiler compiler_;
  vm::PageStore<GcodePage> pages_;
  NameTable names_;
  std::vector<Program> programs_;
  std::unordered_map<std::uint32_t, vm::CodeId> by_number_;  // the first of each
  std::unordered_map<std::string, vm::CodeId> by_name_;
  std::vector<base::Diagnostic> findings_;
  std::vector<UnreadText> unread_;
  vm::CodeId newest_code_{};          // of the page that was compiled here last
  std::uint32_t newest_ = 0;          // its number
  std::uint32_t straight_pages_ = 0;  // up to it, each behind the one before
  PagesAhead ahead_;                  // last: its thread reads the sources
};

}  // namespace kerf::gcode
