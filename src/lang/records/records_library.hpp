#pragma once

#include <string>

#include "base/interface.hpp"
#include "base/text_window.hpp"
#include "lang/records/record_parser.hpp"
#include "lang/vm/line_page.hpp"
#include "lang/vm/straight_program.hpp"

namespace kerf::records {

/// What a do_block instruction executes: a record.
struct RecordBlock {
  /// Its block is the record's own: program, line, column, and the file where that is named.
  motion::Motion motion;
  std::optional<motion::ToolLength> length;
  std::string unknown;  ///< a member that means nothing
  vm::Span centre;      ///< of an arc
  bool is_spiral = false;
  std::vector<ToolRadius> radii;
};

using RecordPage = vm::LinePage<RecordBlock>;

/// Gives the files that records name a place among the sources.
class FileNames : public base::Interface {
 public:
  /// kNoFile: there are too many of them.
  [[nodiscard]] virtual base::FileId id_of(const std::string& name) = 0;
};

/// A file of motion records as a program of the virtual machine, a line a block. Holds the text of
/// some lines.
class RecordsLibrary final : public vm::StraightProgram<RecordPage> {
 public:
  /// All must outlive this.
  RecordsLibrary(const base::SourceSet& sources, FileNames& names, const motion::AxisSetup& axes,
                 const vm::PageSettings& settings);

  /// What the loaded program is called: what its first record says it was, else the name of that
  /// record's program.
  [[nodiscard]] std::string program_name();

 private:
  // vm::StraightProgram
  void rewind() override;
  void compile(RecordPage& page) override;

  void compile_line(const base::TextWindow::Line& line, RecordPage& page);
  void add(const base::Place& place, std::string_view text, Record& record, RecordPage& page);

  const base::SourceSet& sources_;
  FileNames& names_;
  RecordParser parser_;
  base::TextWindow window_;
  std::uint64_t next_offset_ = 0;  // where the next page begins
  std::uint32_t next_line_ = 1;
};

}  // namespace kerf::records
