#pragma once

#include <optional>

#include "base/diagnostic.hpp"
#include "base/text_window.hpp"
#include "lang/teach/record_parser.hpp"
#include "lang/teach/sequence.hpp"

namespace kerf::teach {

/// Reads a .tch file record by record, from its head or from where a reader of it stood before.
/// Holds one line. Every mistake has its line and column; the reader goes on behind it.
class RecordReader {
 public:
  /// Where a reader stands, and what it knows of the records before. Value type.
  struct Position {
    std::uint64_t offset = 0;  ///< of the next line
    std::uint32_t line = 1;    ///< its number
    base::Place last{};        ///< the line with the last record, line 0: none
    Sequence sequence{};
  };

  /// What a line holds: a record or a mistake, or neither where it is empty or a comment.
  struct Line {
    std::string_view text;     ///< valid until the next call
    std::uint64_t offset = 0;  ///< of its first byte in the file
    std::uint32_t number = 0;  ///< from 1
    Words words{std::string_view()};
    std::optional<Record> record;
    std::optional<Mistake> mistake;
  };

  /// The file must outlive the reader's use of it.
  void stand_at(const base::SourceFile& file, base::FileId id, const Position& position);

  /// The next line; false behind the last one.
  [[nodiscard]] bool next(Line& line);
  /// Behind the last line: what is missing, at the line of the last record.
  [[nodiscard]] std::optional<base::Diagnostic> at_end() const;
  /// A line's mistake as it is told.
  [[nodiscard]] base::Diagnostic diagnostic(const Line& line) const;

  [[nodiscard]] const Position& position() const { return position_; }

 private:
  void judge(Line& line);

  base::TextWindow window_;
  base::FileId file_ = base::kNoFile;
  Position position_;
};

}  // namespace kerf::teach
