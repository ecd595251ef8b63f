#pragma once

#include <string>
#include <vector>

#include "base/source_file.hpp"
#include "lang/teach/record_reader.hpp"
#include "lang/teach/record_writer.hpp"

namespace kerf::test {

/// What a .tch file says.
struct TaughtText {
  std::vector<teach::Record> records{};
  std::vector<std::string> mistakes{};  ///< "TEACH_COUNT 3:1+4": line, column, length
  std::string rewritten{};              ///< all lines as the writer writes them, comments kept
};

inline std::string told(const base::Diagnostic& mistake) {
  const base::Place& place = mistake.place;
  return mistake.number + " " + std::to_string(place.line) + ":" + std::to_string(place.column) +
         "+" + std::to_string(place.length);
}

inline TaughtText read_taught(const std::string& text) {
  const auto file = base::SourceFile::from_text("test.tch", text);
  teach::RecordReader reader;
  reader.stand_at(*file, base::FileId{0}, {});
  TaughtText read;
  for (teach::RecordReader::Line line; reader.next(line);) {
    const std::string_view comment = line.words.comment();
    teach::append_line(read.rewritten, line.record ? &*line.record : nullptr,
                       line.words.has_comment() ? &comment : nullptr);
    if (line.mistake) read.mistakes.push_back(told(reader.diagnostic(line)));
    if (line.record) read.records.push_back(*line.record);
  }
  if (const auto missing = reader.at_end()) read.mistakes.push_back(told(*missing));
  return read;
}

}  // namespace kerf::test
